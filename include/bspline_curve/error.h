// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

/// What is wrong with an input; one code per kind of defect, so that callers can tell them apart.
enum class InputErrorCode {
    EmptyMesh,
    NonFiniteCoordinate,
    IndexOutOfRange,
    DegenerateFace,
    NonManifoldEdge,
    NonManifoldVertex,
    InconsistentOrientation,
    SelfIntersection,
    TooFewPicks,
    PickTooFar,
    CoincidentPicks,
    PicksOnDifferentComponents,
    PickAvoided,
    NoPath,
    BadField,
    BadOption,
    UnreadableFile,
    UnwritableFile,
    NoShell,
};

/// The one exception that bad input raises: what is wrong, where, and what to do about it.
class InputError : public std::runtime_error {
public:
    InputError(
        InputErrorCode code, const std::string& message, std::vector<std::int64_t> elements = {}
    )
        : std::runtime_error(message), code_(code), elements_(std::move(elements)) {}

    [[nodiscard]] InputErrorCode code() const { return code_; }

    /// Ids of the faces, vertices or picks concerned, from 0 on, ascending; every one, not only
    /// those in the message, which counts picks from 1.
    [[nodiscard]] const std::vector<std::int64_t>& elements() const { return elements_; }

private:
    InputErrorCode code_;
    std::vector<std::int64_t> elements_;
};

}  // namespace bspline_curve
