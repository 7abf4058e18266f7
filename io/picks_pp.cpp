// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picks_formats.h"
#include "text/text_parsing.h"

#include <tinyxml2.h>

#include <algorithm>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

using std::filesystem::path;

Vec3 pickOfElement(const path& file, const tinyxml2::XMLElement& element) {
    const auto line = static_cast<std::size_t>(element.GetLineNum());
    Vec3 pick;
    for (const auto& [name, k] : {std::pair{"x", 0}, {"y", 1}, {"z", 2}}) {
        const char* const text = element.Attribute(name);
        if (text == nullptr) {
            refuseLine(file, line, std::string("the point has no ") + name);
        }
        pick[k] = coordinateOf(file, line, trimmed(text));
    }
    return pick;
}

}  // namespace

PicksFile picksOfPickPoints(const path& file, const std::string& bytes) {
    tinyxml2::XMLDocument document;
    if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS) {
        const auto line = static_cast<std::size_t>(std::max(document.ErrorLineNum(), 1));
        refuseLine(file, line, std::string("is not XML (") + document.ErrorName() + ")");
    }
    const tinyxml2::XMLElement* const root = document.RootElement();
    if (root == nullptr || std::string_view(root->Name()) != "PickedPoints") {
        refuseFile(file, "is not a PickPoints file (no <PickedPoints>)");
    }
    PicksFile result;
    for (const auto* element = root->FirstChildElement("point"); element != nullptr;
         element = element->NextSiblingElement("point")) {
        const char* const active = element->Attribute("active");
        if (active == nullptr || std::string_view(active) != "0") {
            result.picks.push_back(pickOfElement(file, *element));
        }
    }
    return result;
}

}  // namespace bspline_curve
