// SPDX-License-Identifier: GPL-3.0-or-later
#include "workpiece/curve_notes.h"

#include "text/error_messages.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace bspline_curve {

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

std::vector<std::string> notesOf(const SolveReport& report) {
    std::vector<std::string> notes;
    for (std::string note :
         {describeRepeatedPicks(report), describeDetours(report), describeWeakenedField(report)}) {
        if (!note.empty()) {
            notes.push_back(std::move(note));
        }
    }
    if (!report.fieldAtRest) {
        notes.emplace_back(
            "the field could still be lowered where the iterations ended: it pulls the curve into "
            "bends that are sharper than its knots; smooth the field, or lower its weight"
        );
    }
    if (!report.usable) {
        notes.push_back(describeUnusable(report));
    }
    return notes;
}

std::string describeDetours(const SolveReport& report) {
    std::string text;
    const auto describe = [&](Detour::Round round, const std::string& what) {
        std::vector<std::int64_t> picks;
        double most = 0.0;
        for (const Detour& detour : report.detours) {
            if (detour.round == round) {
                picks.push_back(detour.from);
                most = std::max(most, detour.ratio);
            }
        }
        if (!picks.empty()) {
            text += (text.empty() ? "behind " : "; behind ") + describePicks(picks) +
                    " the curve is up to " + describeNumber(most) + " times as long as " + what;
        }
    };
    describe(
        Detour::Round::Slit,
        "a way over slits, where edges lie on each other: the options strict and slits leave them "
        "open, and so does a surface that would be one-sided"
    );
    describe(
        Detour::Round::Cut,
        "a way over edges that mending has cut, which no curve could take: the surface is "
        "one-sided there, or has edges of hardly any length"
    );
    describe(
        Detour::Round::Guides,
        "the shortest path on the mesh: what it follows or avoids leads it round"
    );
    return text;
}

}  // namespace bspline_curve
