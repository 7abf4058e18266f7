// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/error_messages.h"

#include "bspline_curve/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bspline_curve {
namespace {

constexpr std::array kCodeNames{
    std::pair(InputErrorCode::EmptyMesh, "empty-mesh"),
    std::pair(InputErrorCode::NonFiniteCoordinate, "non-finite-coordinate"),
    std::pair(InputErrorCode::IndexOutOfRange, "index-out-of-range"),
    std::pair(InputErrorCode::DegenerateFace, "degenerate-face"),
    std::pair(InputErrorCode::NonManifoldEdge, "non-manifold-edge"),
    std::pair(InputErrorCode::NonManifoldVertex, "non-manifold-vertex"),
    std::pair(InputErrorCode::InconsistentOrientation, "inconsistent-orientation"),
    std::pair(InputErrorCode::SelfIntersection, "self-intersection"),
    std::pair(InputErrorCode::TooFewPicks, "too-few-picks"),
    std::pair(InputErrorCode::PickTooFar, "pick-too-far"),
    std::pair(InputErrorCode::CoincidentPicks, "coincident-picks"),
    std::pair(InputErrorCode::PicksOnDifferentComponents, "picks-on-different-components"),
    std::pair(InputErrorCode::PickAvoided, "pick-avoided"),
    std::pair(InputErrorCode::NoPath, "no-path"),
    std::pair(InputErrorCode::BadField, "bad-field"),
    std::pair(InputErrorCode::BadOption, "bad-option"),
    std::pair(InputErrorCode::UnreadableFile, "unreadable-file"),
    std::pair(InputErrorCode::UnwritableFile, "unwritable-file"),
    std::pair(InputErrorCode::NoShell, "no-shell"),
};

}  // namespace

const char* name(InputErrorCode code) {
    for (const auto& [known, name] : kCodeNames) {
        if (code == known) {
            return name;
        }
    }
    throw std::logic_error("an error code without a name");
}

std::string describeElements(const std::vector<std::int64_t>& elements) {
    constexpr std::size_t kNamedElements = 5;
    const std::size_t named = std::min(elements.size(), kNamedElements);
    std::string text;
    for (std::size_t i = 0; i < named; ++i) {
        text += (i == 0 ? "" : ", ") + std::to_string(elements[i]);
    }
    if (named < elements.size()) {
        text += " and " + std::to_string(elements.size() - named) + " more";
    }
    return text;
}

std::string describePicks(std::vector<std::int64_t> picks) {
    for (std::int64_t& pick : picks) {
        ++pick;
    }
    return (picks.size() == 1 ? "pick " : "picks ") + describeElements(picks);
}

std::string describeCount(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

void refuseElements(
    InputErrorCode code,
    const std::string& what,
    const std::string& noun,
    std::vector<std::int64_t> elements,
    const std::string& remedy
) {
    const std::string message =
        what + " (" + noun + " " + describeElements(elements) + "): " + remedy;
    throw InputError(code, message, std::move(elements));
}

std::string withRemedy(const std::string& message, const Remedy& remedy, const RemedyWords& words) {
    std::string text(
        remedy.kind == Remedy::Kind::Mend   ? words.mend
        : remedy.kind == Remedy::Kind::Weld ? words.weld
                                            : ""
    );
    if (const std::size_t at = text.find('%'); at != std::string::npos) {
        text.replace(at, 1, describeNumber(remedy.distance));
    }
    return text.empty() ? message : message + "; " + text;
}

std::string describeNumber(double value) {
    constexpr int kSignificantDigits = 4;
    constexpr double kFirstRounded = 1e4;  // numbers from here to the next have no decimals
    constexpr double kFirstWithExponent = 1e9;
    std::array<char, 32> text{};
    const double size = std::abs(value);
    if (size >= kFirstRounded && size < kFirstWithExponent) {
        const double unit = std::pow(10.0, std::floor(std::log10(size)) + 1 - kSignificantDigits);
        return std::to_string(std::llround(std::round(value / unit) * unit));
    }
    const auto [end, error] = std::to_chars(
        text.data(),
        text.data() + text.size(),
        value,
        std::chars_format::general,
        kSignificantDigits
    );
    return {text.data(), end};
}

std::string describeLength(double length) {
    return describeNumber(length) + " mesh units";
}

}  // namespace bspline_curve
