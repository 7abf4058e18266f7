// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/imprint.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

/// Which parts of an imprinted mesh are meant. All but Seeds look only at parts that a curve parts
/// from another part.
struct PartChoice {
    enum class Which {
        Largest,
        Smallest,
        Inside,   ///< those that an odd number of curves parts from the largest of their component;
                  ///< where strokes were imprinted, these
        Outside,  ///< those that an even number does; those that are no strokes
        Seeds,    ///< those at some points
    };

    Which which = Which::Largest;
    std::vector<Vec3> seeds = {};  ///< near the surface
    /// Components that no curve parts stay, unless they are dropped; a seed keeps one then.
    bool dropUntouched = false;
};

enum class FillShape : std::uint8_t {
    Flat,    ///< a triangulation of the rim that bends least, in a plane where the rim is
    Smooth,  ///< new vertices, as dense as those around, faired to go on in the tangent planes
};

/// Chosen parts of an imprinted mesh, opened along its curves, or with the holes filled that the
/// others leave.
struct FilledParts {
    TriangleMesh mesh;
    std::vector<int> source;  ///< for each vertex that of the imprinted mesh; -1: new
    std::vector<int> faces;   ///< for each face that of the imprinted mesh; -1: new
    std::vector<int> labels;  ///< for each face its part; -1: new
    /// For the last faces, those of a relief or solid that have no face of the imprinted mesh: one
    /// of its faces that each corner is on, so at a wall's foot or top.
    std::vector<Triangle> walls;
    std::vector<std::vector<int>> rims;  ///< of the filled holes, vertices of `mesh`
    std::vector<int> firstNew;           ///< for each of these its first new vertex
    std::vector<int> firstFace;          ///< likewise its first new face; they are the last faces
    int endOfNew = 0;           ///< behind the last; copies follow, of vertices where holes meet
    std::vector<int> crossing;  ///< new faces that cross others, ascending
    int openRims = 0;           ///< left open, since the boundary of the input is part of them

    /// Values at the vertices, from those of the imprinted mesh: harmonic in a
    /// filled hole.
    [[nodiscard]] std::vector<double> carried(std::span<const double> imprintedValues) const;
};

/// A mesh that was made from a workpiece's by imprinting curves, and where all of it comes from, so
/// that hosts can carry over what goes with that. Shares the imprint with other parts of it.
class MadeMesh {
public:
    /// Of some parts of an imprint, with the ids of Imprint::mesh.
    MadeMesh(const Imprint& imprint, FilledParts taken);

    [[nodiscard]] const TriangleMesh& mesh() const { return taken_.mesh; }

    [[nodiscard]] const FilledParts& parts() const { return taken_; }

    /// The imprint that it is made of: where a relief has a profile, one with further edges.
    [[nodiscard]] const ImprintedMesh& imprinted() const { return *imprint_; }

    /// For each face its part; -1: it fills a hole.
    [[nodiscard]] const std::vector<int>& labels() const { return taken_.labels; }

    /// The workpiece's vertex that a vertex is, at the same place; -1: it is new. Several vertices
    /// may be one that mending doubled.
    [[nodiscard]] int vertexOf(int vertex) const;
    /// The workpiece's face that a face is part of; -1: it fills a hole.
    [[nodiscard]] int faceOf(int face) const;
    /// Barycentric coordinates of a corner of a face in the workpiece's face that it is part of.
    /// Expects a face that is part of one.
    [[nodiscard]] Vec3 placeOf(int face, int corner) const;
    /// Values at the vertices, from those at the workpiece's: linear in each face; harmonic
    /// in a filled hole.
    [[nodiscard]] std::vector<double> carried(std::span<const double> values) const;
    /// 1 for each vertex on a curve, else 0.
    [[nodiscard]] std::vector<double> curveFlags() const;

private:
    std::shared_ptr<const Imprint::Source> source_;
    std::shared_ptr<const ImprintedMesh> joined_;
    std::shared_ptr<const ImprintedMesh> imprint_;
    FilledParts taken_;
};

/// The whole imprint as a mesh.
[[nodiscard]] MadeMesh wholeMesh(const Imprint& imprint);

/// A base of parts, as of a die: their rims go straight to a plane, in which they are closed.
struct PartBase {
    /// From the parts' farthest point to the plane, > 0; or a height is given.
    double length = 0.0;
    /// From the rims to the plane; none: against the parts' mean normal.
    std::optional<Vec3> direction{};
    /// Of the plane, whose points p have direction . p = height for the direction made a unit
    /// vector; needs a direction.
    std::optional<double> height{};
};

/// How a relief rises from its rim inwards, over a width.
enum class ReliefProfile : std::uint8_t {
    Step,   ///< at once, by a wall
    Ramp,   ///< straight
    Round,  ///< as a quarter of an ellipse, upright at the rim
};

/// What a cut leaves.
struct CutChoice {
    std::optional<PartChoice> keep{};  ///< none: all parts
    bool split = false;                ///< where all are kept: a mesh for each part
    /// Of holes that the other parts leave; none: they stay open. With `split` those of each part;
    /// flat patches are then the same triangles on both sides of a cut, unless curves cross there,
    /// or patches can be sound on one side alone.
    std::optional<FillShape> fill{};
    double relief = 0.0;  ///< height that the parts to keep are moved by; 0: they are cut out
    ReliefProfile profile = ReliefProfile::Step;
    /// Of the profile, along the surface; 0: the relief's height, of strokes half their width.
    double profileWidth = 0.0;
    /// Of the walls that parts become, closed solids, which are cut out then; outwards where it is
    /// positive, inwards where it is negative; 0: they become none. Alternative to `fill`.
    double thickness = 0.0;
    std::optional<PartBase> base{};  ///< that makes solids of parts which are cut out; likewise
};

struct CutMeshes {
    struct Piece {
        std::vector<int> parts;  ///< that it has, ascending
        MadeMesh mesh;
    };

    std::vector<Piece> pieces;  ///< the one with the largest part first
    std::vector<int> dropped;   ///< parts that no piece has, ascending
    int doubledVertices = 0, filledHoles = 0;
    std::vector<std::string> notes;
};

/// The mesh opened along the curves. Throws InputError (NoPath) where they open nothing;
/// (BadOption) where holes are to be filled though all parts are kept in one mesh.
[[nodiscard]] CutMeshes cutOn(
    const Imprint& imprint, const CutChoice& choice, const Progress& progress = {}
);

/// Which of the holes that a mesh has are closed: those for which all of this holds.
struct HoleChoice {
    double mostLength =
        std::numeric_limits<double>::infinity();      ///< of the rim, in the mesh's unit
    int mostEdges = std::numeric_limits<int>::max();  ///< of the rim
    std::optional<Vec3> seed{};  ///< the hole whose rim has the vertex nearest to it
};

/// The whole mesh with holes closed that it has, in one piece. The outer boundary of an open
/// surface is a hole like the others. Throws InputError (NoPath) where no hole is chosen or a rim
/// cannot be filled, Cancelled. New faces cross others only where a note names them.
[[nodiscard]] CutMeshes holesFilled(
    const Imprint& imprint, const HoleChoice& choice, FillShape shape, const Progress& progress = {}
);

/// Each part by itself, and those together that no curve parts from another. Throws InputError
/// (NoPath) where curves part nothing.
[[nodiscard]] CutMeshes segmentsOf(const Imprint& imprint, bool split);

}  // namespace bspline_curve
