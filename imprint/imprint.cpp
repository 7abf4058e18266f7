// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/imprint.h"

#include "bspline_curve/error.h"
#include "imprint/curve_arrangement.h"
#include "imprint/face_triangulation.h"
#include "imprint/imprint_nodes.h"
#include "surface/predicates.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

namespace bspline_curve {

namespace {

constexpr double kMaxSnap = 0.01;
/// Where new faces are flat, snapping is tried with this many times the distance.
constexpr double kWiderSnap = 16.0;
/// The smallest snapping distance that is widened, above rounding.
constexpr double kLeastSnap = 1e-12;
/// A new face's normal is within 60 degrees of its parent's, else it is flat.
constexpr double kLeastCosine = 0.5;

struct CurvePiece {
    int face, from, to;
};

/// One try with given snapping distances.
class Imprinter {
public:
    Imprinter(
        const Surface& surface,
        std::span<const SurfacePolyline> curves,
        const SnapDistances& snap,
        const GoOn& goOn
    )
        : surface_(surface),
          curves_(curves),
          nodes_(surface, snap),
          arrangement_(surface, nodes_, snap) {
        addCurves();
        goOn();
        arrangement_.resolve();
        goOn();
        numberVertices();
        divideFaces();
        goOn();
    }

    /// Parents of children that are flat or turned over, ascending.
    [[nodiscard]] const std::vector<int>& flatFaces() const { return flatFaces_; }

    [[nodiscard]] ImprintedMesh result(const GoOn& goOn) const;

private:
    /// The children of one face in `triangles_`.
    struct Children {
        int face, first, count;
    };

    void addCurves();
    void numberVertices();
    void divideFaces();
    void divide(int face);
    [[nodiscard]] std::vector<int> touchedFaces() const;

    [[nodiscard]] int vertexOf(int node) const { return node < 0 ? ~node : vertexOf_[node]; }

    [[nodiscard]] const Vec3& position(int vertex) const;
    [[nodiscard]] bool isSound(int face, const Triangle& child) const;
    [[nodiscard]] int commonFaceOf(std::size_t curve, std::size_t point) const;
    [[nodiscard]] ImprintedCurve imprintedCurve(std::size_t curve) const;

    const Surface& surface_;
    std::span<const SurfacePolyline> curves_;
    ImprintNodes nodes_;
    CurveArrangement arrangement_;
    std::vector<std::vector<CurvePiece>> pieces_;  // of each curve
    std::vector<int> vertexOf_;                    // of each node off the vertices
    std::vector<int> newNodes_;                    // the node of each new vertex
    std::vector<Vec3> newPositions_;
    FaceTriangulation triangulation_;
    std::vector<int> nodesOfFace_;    // of the face at hand: the nodes of its points 3, 4, …
    std::vector<Children> children_;  // by face, ascending
    std::vector<Triangle> triangles_;
    std::vector<int> flatFaces_;
    double largestMove_ = 0.0;
};

/// A face that holds the segment from a point of a curve to the next, a face of one of the two
/// where there is a choice.
int Imprinter::commonFaceOf(std::size_t curve, std::size_t point) const {
    const std::vector<SurfacePoint>& points = curves_[curve].surfacePoints;
    const std::size_t next = (point + 1) % points.size();
    const SurfacePoint &from = points[point], &to = points[next];
    const std::vector<int> holders = facesHolding(surface_, to);
    if (contains(holders, from.face)) {
        return from.face;
    }
    if (contains(facesHolding(surface_, from), to.face)) {
        return to.face;
    }
    const int face = commonFace(surface_, from, to);
    if (face < 0) {
        throw InputError(
            InputErrorCode::NoPath,
            "curve " + std::to_string(curve) + ": the segment from vertex " +
                std::to_string(point) + " to " + std::to_string(next) +
                " is not in one face; imprint polylines that lie strictly on the mesh",
            {static_cast<std::int64_t>(point)}
        );
    }
    return face;
}

void Imprinter::addCurves() {
    // Points become nodes in an order that is not that of the curves.
    // By face and barycentric coordinates; then the curve and its point.
    std::vector<std::tuple<int, double, double, double, std::size_t, std::size_t>> places;
    std::vector<std::vector<int>> nodeOf(curves_.size());
    for (std::size_t c = 0; c < curves_.size(); ++c) {
        nodeOf[c].resize(curves_[c].surfacePoints.size());
        for (std::size_t i = 0; i < curves_[c].surfacePoints.size(); ++i) {
            const auto& [face, barycentric] = curves_[c].surfacePoints[i];
            places.emplace_back(face, barycentric[0], barycentric[1], barycentric[2], c, i);
        }
    }
    std::ranges::sort(places);
    for (const auto& [face, b0, b1, b2, c, i] : places) {
        const SurfacePoint& point = curves_[c].surfacePoints[i];
        const int node = nodes_.add(face, point.barycentric);
        nodeOf[c][i] = node;
        largestMove_ =
            std::max(largestMove_, (nodes_.position(node) - surface_.position(point)).norm());
    }
    pieces_.resize(curves_.size());
    for (std::size_t c = 0; c < curves_.size(); ++c) {
        const std::size_t count = nodeOf[c].size();
        for (std::size_t i = 0; i + 1 < count + (curves_[c].closed ? 1 : 0); ++i) {
            const CurvePiece piece{commonFaceOf(c, i), nodeOf[c][i], nodeOf[c][(i + 1) % count]};
            pieces_[c].push_back(piece);
            arrangement_.add(piece.face, piece.from, piece.to);
        }
    }
}

/// Numbers new vertices: those on edges by edge and along it, then those in faces.
void Imprinter::numberVertices() {
    newNodes_.resize(nodes_.count());
    std::iota(newNodes_.begin(), newNodes_.end(), 0);
    std::ranges::sort(newNodes_, {}, [&](int node) {
        const ImprintNode& at = nodes_[node];
        return std::tuple(at.on, at.element, at.place.x(), at.place.y());
    });
    vertexOf_.resize(newNodes_.size());
    newPositions_.reserve(newNodes_.size());
    for (const int node : newNodes_) {
        vertexOf_[node] = surface_.vertexCount() + static_cast<int>(newPositions_.size());
        newPositions_.push_back(nodes_.position(node));
    }
}

/// Faces with segments in them or nodes on their sides, ascending.
std::vector<int> Imprinter::touchedFaces() const {
    std::vector<int> touched = arrangement_.faces();
    for (int node = 0; node < nodes_.count(); ++node) {
        if (nodes_[node].on == ImprintNode::On::Edge) {
            for (const int face : nodes_.facesOfEdge(nodes_[node].element)) {
                touched.push_back(face);
            }
        }
    }
    sortUnique(touched);
    std::erase(touched, -1);
    return touched;
}

void Imprinter::divideFaces() {
    for (const int face : touchedFaces()) {
        const std::size_t first = triangles_.size();
        divide(face);
        children_.push_back(
            {face, static_cast<int>(first), static_cast<int>(triangles_.size() - first)}
        );
        if (!std::all_of(
                triangles_.begin() + static_cast<std::ptrdiff_t>(first),
                triangles_.end(),
                [&](const Triangle& child) { return isSound(face, child); }
            )) {
            flatFaces_.push_back(face);
        }
    }
}

/// Appends the children of a face, the one at its first corner first.
void Imprinter::divide(int face) {
    const Triangle& corners = surface_.faces()[face];
    triangulation_.start(
        surface_.vertices()[corners[0]],
        surface_.vertices()[corners[1]],
        surface_.vertices()[corners[2]]
    );
    nodesOfFace_.clear();
    for (int k = 0; k < 3; ++k) {
        nodes_.appendOnSide(face, k, nodesOfFace_);
    }
    nodes_.appendInside(face, nodesOfFace_);
    for (const int node : nodesOfFace_) {
        triangulation_.addPoint(nodes_.placeIn(node, face));
    }
    constexpr int kCorners = 3;
    const auto pointAt = [&](int node) {
        return node < 0
                   ? cornerOf(corners, ~node)
                   : kCorners + static_cast<int>(
                                    std::ranges::find(nodesOfFace_, node) - nodesOfFace_.begin()
                                );
    };
    for (const ImprintSegment& segment : arrangement_.segmentsIn(face)) {
        triangulation_.addSegment(pointAt(segment.a), pointAt(segment.b));
    }
    const std::size_t first = triangles_.size();
    triangulation_.appendTriangles(triangles_);
    const std::span children = std::span(triangles_).subspan(first);
    for (Triangle& child : children) {
        std::ranges::rotate(child, std::ranges::min_element(child));
    }
    std::ranges::sort(children);
    for (Triangle& child : children) {
        for (int& point : child) {
            point = point < kCorners ? corners.at(point) : vertexOf(nodesOfFace_[point - kCorners]);
        }
    }
}

const Vec3& Imprinter::position(int vertex) const {
    const int old = surface_.vertexCount();
    return vertex < old ? surface_.vertices()[vertex] : newPositions_[vertex - old];
}

/// Whether a child has area and its parent's orientation as its vertices are rounded.
bool Imprinter::isSound(int face, const Triangle& child) const {
    const Triangle& corners = surface_.faces()[face];
    const Vec3 &a = position(corners[0]), &b = position(corners[1]), &c = position(corners[2]);
    const Vec3 &p = position(child[0]), &q = position(child[1]), &r = position(child[2]);
    const Vec3 normal = (b - a).cross(c - a);
    const Vec3 own = (q - p).cross(r - p);
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const int dropped = static_cast<int>(axis);
    return projectedOrientationSign(p, q, r, dropped) ==
               projectedOrientationSign(a, b, c, dropped) &&
           normal.dot(own) > kLeastCosine * normal.norm() * own.norm();
}

ImprintedCurve Imprinter::imprintedCurve(std::size_t curve) const {
    const std::vector<CurvePiece>& pieces = pieces_[curve];
    std::vector<int> path{pieces.front().from};
    for (const CurvePiece& piece : pieces) {
        arrangement_.appendPath(piece.face, piece.from, piece.to, path);
    }
    ImprintedCurve result{.closed = curves_[curve].closed, .vertices = {}};
    for (const int node : path) {
        const int vertex = vertexOf(node);
        if (result.vertices.empty() || result.vertices.back() != vertex) {
            result.vertices.push_back(vertex);
        }
    }
    if (result.closed && result.vertices.size() > 1 &&
        result.vertices.front() == result.vertices.back()) {
        result.vertices.pop_back();
    }
    return result;
}

/// Vertices where more than two edges of curves meet, ascending.
std::vector<int> crossingsOf(const std::vector<ImprintedCurve>& curves) {
    std::vector<std::array<int, 2>> edges;
    for (const auto& [closed, vertices] : curves) {
        const std::size_t count = vertices.size();
        for (std::size_t i = 0; i + 1 < count + (closed ? 1 : 0); ++i) {
            const auto [low, high] = std::minmax(vertices[i], vertices[(i + 1) % count]);
            edges.push_back({low, high});
        }
    }
    sortUnique(edges);
    std::vector<int> ends;
    for (const auto& [low, high] : edges) {
        ends.insert(ends.end(), {low, high});
    }
    std::ranges::sort(ends);
    std::vector<int> crossings;
    for (std::size_t i = 2; i < ends.size(); ++i) {
        if (ends[i] == ends[i - 2]) {
            crossings.push_back(ends[i]);
        }
    }
    sortUnique(crossings);
    return crossings;
}

ImprintedMesh Imprinter::result(const GoOn& goOn) const {
    ImprintedMesh result;
    result.surfaceVertexCount = surface_.vertexCount();
    result.mesh.vertices.reserve(surface_.vertices().size() + newPositions_.size());
    result.mesh.vertices = surface_.vertices();
    result.mesh.vertices.insert(
        result.mesh.vertices.end(), newPositions_.begin(), newPositions_.end()
    );
    goOn();
    const std::size_t faceCount = surface_.faces().size() + triangles_.size() - children_.size();
    result.mesh.faces.reserve(faceCount);
    result.ownParents.reserve(faceCount);
    int next = 0;
    const auto keepUntil = [&](int end) {
        result.mesh.faces.insert(
            result.mesh.faces.end(), surface_.faces().begin() + next, surface_.faces().begin() + end
        );
        for (; next < end; ++next) {
            result.ownParents.push_back(next);
        }
    };
    for (const auto& [face, first, count] : children_) {
        keepUntil(face);
        const auto children = triangles_.begin() + first;
        result.mesh.faces.insert(result.mesh.faces.end(), children, children + count);
        result.ownParents.resize(result.mesh.faces.size(), face);
        result.dividedFaces += count > 1 ? 1 : 0;
        next = face + 1;
    }
    keepUntil(surface_.faceCount());
    goOn();
    result.ownPlaces.reserve(newNodes_.size());
    for (const int node : newNodes_) {
        result.ownPlaces.push_back(nodes_.surfacePoint(node));
    }
    for (std::size_t c = 0; c < pieces_.size(); ++c) {
        result.curves.push_back(imprintedCurve(c));
    }
    result.crossings = crossingsOf(result.curves);
    result.largestMove = std::max(largestMove_, arrangement_.largestMove());
    return result;
}

}  // namespace

void ImprintOptions::validate() const {
    const bool isInRange = snap >= 0.0 && snap <= kMaxSnap;
    if (!isInRange) {
        throw InputError(
            InputErrorCode::BadOption,
            "snap is " + describeNumber(snap) + ", but must be in [0, 0.01]"
        );
    }
}

namespace {

/// Says where all of it is on the input; first come the corners that mending has doubled.
void bringToInput(const Surface& surface, ImprintedMesh& imprinted) {
    const Provenance& provenance = surface.provenance();
    imprinted.parents = imprinted.ownParents;
    if (provenance.isIdentity()) {
        imprinted.newVertices = imprinted.ownPlaces;
        imprinted.doubledVertices.resize(imprinted.newVertices.size(), -1);
        return;
    }
    for (int& parent : imprinted.parents) {
        parent = provenance.inputFace(parent);
    }
    const auto first = static_cast<int>(surface.input().vertices.size());
    for (int copy = first; copy < surface.vertexCount(); ++copy) {
        if (surface.facesAround(copy).empty()) {  // faces were joined anew, which had it
            imprinted.newVertices.push_back({.face = -1, .barycentric = Vec3::Zero()});
            imprinted.doubledVertices.push_back(-1);
            continue;
        }
        const int face = *surface.facesAround(copy).begin();
        const int k = cornerOf(surface.faces()[face], copy);
        imprinted.newVertices.push_back(
            provenance.toInput({.face = face, .barycentric = Vec3::Unit(k)})
        );
        imprinted.doubledVertices.push_back(
            provenance.hasInputCorners() ? provenance.inputCorners()[face].at(k)
                                         : provenance.inputVertex(copy)
        );
    }
    for (const SurfacePoint& point : imprinted.ownPlaces) {
        imprinted.newVertices.push_back(provenance.toInput(point));
    }
    imprinted.doubledVertices.resize(imprinted.newVertices.size(), -1);
}

}  // namespace

ImprintedMesh imprint(
    const Surface& surface,
    std::span<const SurfacePolyline> curves,
    const ImprintOptions& options,
    const GoOn& goOn
) {
    std::vector<SurfacePolyline> own;
    if (!surface.provenance().isIdentity()) {
        for (const SurfacePolyline& curve : curves) {
            own.push_back(strictLine(surface, curve, "curve " + std::to_string(own.size())));
        }
        curves = own;
    }
    ImprintedMesh imprinted = imprintOwn(surface, curves, options, goOn);
    goOn();
    bringToInput(surface, imprinted);
    return imprinted;
}

SurfacePoint ownPlace(
    const Surface& surface, const ImprintedMesh& imprinted, int face, int corner
) {
    const int vertex = imprinted.mesh.faces[face].at(corner);
    const int own = imprinted.ownParents[face];
    if (vertex >= imprinted.surfaceVertexCount) {
        return inFace(surface, imprinted.ownPlaces[vertex - imprinted.surfaceVertexCount], own);
    }
    return {.face = own, .barycentric = Vec3::Unit(cornerOf(surface.faces()[own], vertex))};
}

ImprintedMesh imprintOwn(
    const Surface& surface,
    std::span<const SurfacePolyline> curves,
    const ImprintOptions& options,
    const GoOn& goOn
) {
    options.validate();
    for (std::size_t c = 0; c < curves.size(); ++c) {
        if (curves[c].surfacePoints.size() < 2) {
            throw InputError(
                InputErrorCode::NoPath,
                "curve " + std::to_string(c) + " has no segment: at least two points are needed"
            );
        }
    }
    SnapDistances snap(options.snap);
    for (;;) {
        const Imprinter imprinter(surface, curves, snap, goOn);
        if (imprinter.flatFaces().empty()) {
            return imprinter.result(goOn);
        }
        std::vector<std::int64_t> hopeless;
        for (const int face : imprinter.flatFaces()) {
            const double wider = kWiderSnap * std::max(snap.in(face), kLeastSnap);
            if (options.snap == 0.0 || wider > kMaxSnap) {
                hopeless.push_back(face);
            }
            snap.widen(face, wider);
        }
        if (!hopeless.empty()) {
            refuseElements(
                InputErrorCode::NoPath,
                "new faces would be flat in " + describeCount(hopeless.size(), "face", "faces"),
                "face",
                hopeless,
                options.snap == 0.0 ? "allow snapping"
                                    : "these faces are too thin for a curve; mend the mesh there"
            );
        }
    }
}

}  // namespace bspline_curve
