// SPDX-License-Identifier: GPL-3.0-or-later
// In place of the readers of XML where there is no parser of it.
#include "io/picks_formats.h"
#include "io/polyline_formats.h"
#include "io/xml_tree.h"
#include "text/text_parsing.h"

namespace bspline_curve {

namespace {

[[noreturn]] void refuseXml(const std::filesystem::path& file) {
    refuseFile(file, "is XML, which cannot be read here; the program on the desktop can");
}

}  // namespace

PicksFile picksOfPickPoints(const std::filesystem::path& file, const std::string& /*bytes*/) {
    refuseXml(file);
}

PolylineGraph polylinesOfVtu(const std::filesystem::path& file, std::string_view /*bytes*/) {
    refuseXml(file);
}

XmlElement xmlTreeOf(const std::filesystem::path& file, std::string_view /*bytes*/) {
    refuseXml(file);
}

}  // namespace bspline_curve
