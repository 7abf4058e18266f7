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

/// What helps against an error: it was tried. Hosts say it in words of their own.
struct Remedy {
    enum class Kind {
        None,  ///< none is known
        Mend,  ///< not to ask for a mesh that needs no mending
        Weld,  ///< to join vertices within `distance`
    };

    Kind kind = Kind::None;
    double distance = 0.0;  ///< relative to the diagonal of the mesh
};

/// The one exception that bad input raises: what is wrong, where, and what to do about it.
class InputError : public std::runtime_error {
public:
    InputError(
        InputErrorCode code,
        const std::string& message,
        std::vector<std::int64_t> elements = {},
        Remedy remedy = {}
    )
        : std::runtime_error(message),
          code_(code),
          elements_(std::move(elements)),
          remedy_(remedy) {}

    [[nodiscard]] InputErrorCode code() const { return code_; }

    /// What helps, in no host's words; not part of the message.
    [[nodiscard]] const Remedy& remedy() const { return remedy_; }

    /// Ids of the faces, vertices or picks concerned, from 0 on, ascending; every one, not only
    /// those in the message, which counts picks from 1.
    [[nodiscard]] const std::vector<std::int64_t>& elements() const { return elements_; }

private:
    InputErrorCode code_;
    std::vector<std::int64_t> elements_;
    Remedy remedy_;
};

}  // namespace bspline_curve
