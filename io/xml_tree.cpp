// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/xml_tree.h"

#include "text/text_parsing.h"

#include <tinyxml2.h>

#include <algorithm>

namespace bspline_curve {

namespace {

XmlElement treeOf(const tinyxml2::XMLElement& element) {
    const std::string_view name(element.Name());
    const std::size_t colon = name.rfind(':');
    XmlElement result{
        .name = std::string(colon == std::string_view::npos ? name : name.substr(colon + 1)),
        .attributes = {},
        .children = {},
        .text = element.GetText() != nullptr ? element.GetText() : "",
        .line = static_cast<std::size_t>(element.GetLineNum())
    };
    for (const auto* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
        result.attributes.emplace_back(each->Name(), each->Value());
    }
    for (const auto* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
        result.children.push_back(treeOf(*child));
    }
    return result;
}

}  // namespace

XmlElement xmlTreeOf(const std::filesystem::path& file, std::string_view bytes) {
    tinyxml2::XMLDocument document;
    const bool isXml = document.Parse(bytes.data(), bytes.size()) == tinyxml2::XML_SUCCESS;
    if (!isXml || document.RootElement() == nullptr) {
        const auto line = static_cast<std::size_t>(std::max(document.ErrorLineNum(), 1));
        refuseLine(file, line, std::string("is not XML (") + document.ErrorName() + ")");
    }
    return treeOf(*document.RootElement());
}

}  // namespace bspline_curve
