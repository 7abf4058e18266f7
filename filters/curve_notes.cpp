// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/curve_notes.h"

#include "surface/error_messages.h"

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bspline_curve {

std::string asSentence(std::string note) {
    note.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(note.front())));
    return note + ".";
}

std::string describeUnusable(const SolveReport& report) {
    constexpr double kMissed = 1e-9;  // of the diagonal; constraints are met to rounding
    std::string text = std::string("the curve is not usable (") + name(report.status) +
                       "): the spline is up to " +
                       describeLength(report.maxDistance * report.meanEdgeLength) +
                       " from the surface, the tolerance is " +
                       describeNumber(report.allowedDistance * report.meanEdgeLength);
    if (report.farPart) {
        const FarPart& part = *report.farPart;
        const std::vector<std::int64_t> faces(part.faces.begin(), part.faces.end());
        text += ", between t = " + describeNumber(part.from) + " and " + describeNumber(part.to) +
                " (faces " + describeElements(faces) + ")";
    }
    if (report.maxPickGap > kMissed) {
        text += "; it misses a pick by " + describeLength(report.maxPickGap * report.diagonal);
    }
    return text + "; try more picks, a finer mesh or a larger distance tolerance";
}

std::string describeWeakenedField(const SolveReport& report) {
    if (report.fieldShare == 1.0) {
        return "";
    }
    return "the field drew the curve past its first or last pick, so it has " +
           describeNumber(report.fieldShare) + " of the weight that was asked for";
}

std::string describeRepeatedPicks(const SolveReport& report) {
    const std::vector<std::int64_t> picks(report.repeatedPicks.begin(), report.repeatedPicks.end());
    if (picks.empty()) {
        return "";
    }
    return describePicks(picks) + (picks.size() == 1 ? " is" : " are") +
           " at the same point of the surface as the one before; the curve passes it once";
}

std::string describeLayers(const std::vector<std::string>& names) {
    constexpr std::size_t kMostNames = 6;
    const std::size_t named = names.size() > kMostNames ? kMostNames - 1 : names.size();
    std::string text = "The mesh is parted into " + std::to_string(names.size()) + " layers: ";
    for (std::size_t i = 0; i < named; ++i) {
        const bool isLast = i + 1 == names.size();
        text += (i == 0 ? "\"" : isLast ? " and \"" : ", \"") + names[i] + "\"";
    }
    if (named < names.size()) {
        text += " and " + std::to_string(names.size() - named) + " more";
    }
    return text + ".";
}

}  // namespace bspline_curve
