// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/field.h"
#include "bspline_curve/options.h"
#include "bspline_curve/shell.h"
#include "surface/region.h"
#include "workpiece/pick_choice.h"
#include "workpiece/pick_directions.h"

#include <optional>
#include <vector>

// What people ask for of a curve, in every host.
namespace bspline_curve {

/// Which faces of a mesh are meant.
struct FaceChoice {
    enum class By {
        Nothing,
        Ids,  ///< `ids`
        SelectedFaces,
        SelectedVertices,  ///< faces all of whose corners are selected
        UnderThreshold,    ///< faces over which the mean of the field (without one, of the quality)
        OverThreshold,     ///< is under or over `threshold`
    };

    By by = By::Nothing;
    double threshold = 0.0;
    Region ids{};

    [[nodiscard]] bool hasThreshold() const {
        return by == By::UnderThreshold || by == By::OverThreshold;
    }
};

/// A field that is asked for.
struct FieldRequest {
    FieldOptions options;
    FaceChoice region{.by = FaceChoice::By::SelectedFaces};  ///< of FieldKind::Obstacle
    std::vector<double> values{};  ///< of FieldKind::Quality in place of the mesh's; empty: those
    bool automatic = false;        ///< only where canBeFollowed() holds for the quality
};

/// How a curve is drawn through its picks.
struct CurveOptions {
    SolverOptions solver;
    SamplingOptions sampling;
    std::optional<FieldRequest> field;
    FaceChoice avoid;
    PickChoice corners{};       ///< see CurveInputs
    PickDirections tangents{};  ///< likewise
};

/// How a mesh is prepared for curves.
struct PreparingOptions {
    MendingOptions mending{};
    ShellOptions shell{};

    friend bool operator==(const PreparingOptions&, const PreparingOptions&) = default;
};

}  // namespace bspline_curve
