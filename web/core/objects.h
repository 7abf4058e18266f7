// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "bspline_curve/files.h"
#include "bspline_curve/imprint.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/workpiece.h"
#include "filters/option_book.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

// What a page holds on to by number, until it frees it.
namespace bspline_curve::web {

struct Mesh {
    std::shared_ptr<const Workpiece> workpiece;
    LayerInput layer;  ///< what goes with the mesh beside it: its own mesh is empty
    MeshExtras extras{};
};

struct DrawnOnMesh {
    std::shared_ptr<const Mesh> mesh;
    DesignedCurve drawn;
    double deviation = 0.0;  ///< of an offset curve, in distances
};

struct ImprintOnMesh {
    std::shared_ptr<const Mesh> mesh;
    Imprint imprint;
};

struct Session {
    std::shared_ptr<const Mesh> mesh;
    OptionBook options;
    DrawingSession drawing;

    /// What the page knows of each curve, by its id: it is told again only what changed.
    struct Told {
        std::shared_ptr<const SketchCurve> curve;
        std::shared_ptr<const Curve> settled, last;
    };

    std::map<std::uint64_t, Told> told{};
};

using Object = std::variant<
    std::shared_ptr<const Mesh>,
    std::shared_ptr<const DrawnOnMesh>,
    std::shared_ptr<const ImprintOnMesh>,
    std::shared_ptr<Session>>;

/// The number that stands for an object; never given again.
[[nodiscard]] int keep(Object object);
/// Nothing where there is none.
void forget(int number);
/// How many there are.
[[nodiscard]] int objectCount();

/// Throws std::invalid_argument: no object has this number.
[[nodiscard]] const Object& objectOf(int number);

/// The same, of a type. Throws std::invalid_argument where it has another one.
[[nodiscard]] std::shared_ptr<const Mesh> meshOf(int number);
[[nodiscard]] std::shared_ptr<const DrawnOnMesh> curveOf(int number);
[[nodiscard]] std::shared_ptr<const ImprintOnMesh> imprintOf(int number);
[[nodiscard]] std::shared_ptr<Session> sessionOf(int number);

}  // namespace bspline_curve::web
