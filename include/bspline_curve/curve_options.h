// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/field.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/shell.h"
#include "bspline_curve/tangent.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A mesh with what is marked on it: a layer of a host, without the elements that it has deleted,
/// or what a file holds.
struct LayerInput {
    std::string label;                   ///< for messages
    TriangleMesh mesh;                   ///< in world coordinates
    std::vector<double> quality;         ///< one per vertex; empty: the layer has none
    std::vector<char> selectedVertices;  ///< one flag per vertex; empty: nothing is selected
    std::vector<char> selectedFaces;     ///< one flag per face; likewise
    /// Nothing was deleted: the arrays' indices are the layer's.
    bool hasLayersIds = true;
    bool isFile = false;

    /// As messages name it.
    [[nodiscard]] std::string name() const {
        return isFile ? label + ":" : "layer \"" + label + "\"";
    }
};

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

/// Picks that are chosen, whatever curve they are of.
struct PickChoice {
    bool areAll = false;
    std::vector<int> ids{};  ///< from 0, in any order, where not all are chosen

    /// The ids of those of a curve of so many picks; unchecked where they were given.
    [[nodiscard]] std::vector<int> of(std::size_t count) const;

    friend bool operator==(const PickChoice&, const PickChoice&) = default;
};

/// Directions of some picks.
struct PickDirections {
    std::vector<std::pair<int, PickTangent>> entries{};  ///< ids of picks, from 0

    /// One for each of so many picks, see CurveInputs::tangents; empty where there are none. Throws
    /// InputError (BadOption) where a pick is not there.
    [[nodiscard]] std::vector<PickTangent> of(std::size_t count) const;

    friend bool operator==(const PickDirections&, const PickDirections&) = default;
};

/// How near a curve keeps to its picks.
struct PickTolerances {
    struct Entry {
        MeshLength within{};  ///< see CurveInputs::pickTolerances
        double weight = 0.0;  ///< see CurveInputs::pickWeights; 0: `within` holds

        friend bool operator==(const Entry&, const Entry&) = default;
    };

    /// One for all picks, or one for each; empty: SolverOptions::pickTolerance for all.
    std::vector<Entry> entries{};

    /// One for each of so many picks, as CurveInputs takes them; empty where there are none. Throw
    /// InputError (BadOption) where there are neither one nor as many.
    [[nodiscard]] std::vector<MeshLength> within(std::size_t count) const;
    [[nodiscard]] std::vector<double> weights(std::size_t count) const;

    friend bool operator==(const PickTolerances&, const PickTolerances&) = default;
};

/// "1, 4", "1 4": picks counted from 1; "all"; "": none. Throws InputError (BadOption) naming what
/// is none of these; `name`: of the option.
[[nodiscard]] PickChoice parsePickChoice(const std::string& text, const std::string& name);

/// The same back again: "1,4".
[[nodiscard]] std::string describe(const PickChoice& choice);

/// "1: 1, 0, 0; 4: 0 1 0": picks counted from 1, and a vector that is not zero for each; "": none.
/// Of a corner two, before it and after it: "2: 1, 0, 0 / 0, 1, 0"; "any" in place of one of them.
/// Throws InputError (BadOption) naming what is none of these; `name`: of the option.
[[nodiscard]] PickDirections parsePickDirections(const std::string& text, const std::string& name);

/// The same back again, to the bit.
[[nodiscard]] std::string describe(const PickDirections& directions);

/// "0.4", "1 edge", "weight 100": of all picks; "0.4, 0, 1 edge, weight 100": one for each. Throws
/// InputError (BadOption) naming what is none of these; `name`: of the option.
[[nodiscard]] PickTolerances parsePickTolerances(const std::string& text, const std::string& name);

/// Whether the quality of a mesh can be a field, so that curves follow it where `field` is "auto":
/// there is a quality, all of it is finite, and it is not the same everywhere. Takes time in
/// proportion to the vertices.
[[nodiscard]] bool canBeFollowed(std::span<const double> quality);

/// How a curve is drawn through its picks.
struct CurveOptions {
    SolverOptions solver;
    SamplingOptions sampling;
    std::optional<FieldRequest> field;
    FaceChoice avoid;
    PickChoice corners{};       ///< see CurveInputs
    PickDirections tangents{};  ///< likewise
    PickTolerances pickTolerances{};
};

/// How a mesh is prepared for curves.
struct PreparingOptions {
    MendingOptions mending{};
    ShellOptions shell{};

    friend bool operator==(const PreparingOptions&, const PreparingOptions&) = default;
};

}  // namespace bspline_curve
