// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/imprint.h"

#include "bspline_curve/error.h"
#include "imprint/curve_arrangement.h"
#include "imprint/face_triangulation.h"
#include "imprint/imprint_nodes.h"
#include "surface/error_messages.h"
#include "surface/predicates.h"
#include "surface/surface_point.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
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
        const Surface& surface, std::span<const SurfacePolyline> curves, const SnapDistances& snap
    )
        : surface_(surface),
          curves_(curves),
          nodes_(surface, snap),
          arrangement_(surface, nodes_, snap) {
        addCurves();
        arrangement_.resolve();
        numberVertices();
        divideFaces();
    }

    /// Parents of children that are flat or turned over, ascending.
    [[nodiscard]] const std::vector<int>& flatFaces() const { return flatFaces_; }

    [[nodiscard]] ImprintedMesh result() const;

private:
    void addCurves();
    void numberVertices();
    void divideFaces();
    [[nodiscard]] std::vector<Triangle> divided(int face) const;
    [[nodiscard]] bool isSound(int face, const Triangle& child) const;
    [[nodiscard]] int commonFaceOf(std::size_t curve, std::size_t point) const;
    [[nodiscard]] ImprintedCurve imprintedCurve(const std::vector<CurvePiece>& pieces) const;

    const Surface& surface_;
    std::span<const SurfacePolyline> curves_;
    ImprintNodes nodes_;
    CurveArrangement arrangement_;
    std::vector<std::vector<CurvePiece>> pieces_;  // of each curve
    std::vector<int> vertexOf_;                    // of each node
    std::vector<int> newNodes_;                    // the node of each new vertex
    std::vector<Vec3> newPositions_;
    std::map<int, std::vector<Triangle>> children_;
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
    std::vector<std::pair<std::size_t, std::size_t>> order;
    std::vector<std::vector<int>> nodeOf(curves_.size());
    for (std::size_t c = 0; c < curves_.size(); ++c) {
        nodeOf[c].resize(curves_[c].surfacePoints.size());
        for (std::size_t i = 0; i < curves_[c].surfacePoints.size(); ++i) {
            order.emplace_back(c, i);
        }
    }
    const auto key = [&](const std::pair<std::size_t, std::size_t>& each) {
        const SurfacePoint& point = curves_[each.first].surfacePoints[each.second];
        return std::tuple(
            point.face, point.barycentric[0], point.barycentric[1], point.barycentric[2]
        );
    };
    std::ranges::sort(order, {}, key);
    for (const auto& [c, i] : order) {
        const SurfacePoint& point = curves_[c].surfacePoints[i];
        const int node = nodes_.add(point.face, point.barycentric);
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
    vertexOf_.assign(nodes_.count(), -1);
    std::vector<int> order(nodes_.count());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int node) {
        const ImprintNode& at = nodes_[node];
        return std::tuple(at.on, at.element, at.place.x(), at.place.y());
    });
    for (const int node : order) {
        if (nodes_[node].on == ImprintNode::On::Vertex) {
            vertexOf_[node] = nodes_[node].element;
        } else {
            vertexOf_[node] = surface_.vertexCount() + static_cast<int>(newNodes_.size());
            newNodes_.push_back(node);
            newPositions_.push_back(nodes_.position(node));
        }
    }
}

void Imprinter::divideFaces() {
    std::set<int> touched;
    for (const int face : arrangement_.faces()) {
        touched.insert(face);
    }
    for (const int edge : nodes_.dividedEdges()) {
        for (const int face : nodes_.facesOfEdge(edge)) {
            if (face >= 0) {
                touched.insert(face);
            }
        }
    }
    for (const int face : touched) {
        std::vector<Triangle> children = divided(face);
        if (!std::ranges::all_of(children, [&](const Triangle& child) {
                return isSound(face, child);
            })) {
            flatFaces_.push_back(face);
        }
        children_.emplace(face, std::move(children));
    }
}

/// The children of a face, the one at its first corner first.
std::vector<Triangle> Imprinter::divided(int face) const {
    const Triangle& corners = surface_.faces()[face];
    FaceTriangulation triangulation(
        {surface_.vertices()[corners[0]],
         surface_.vertices()[corners[1]],
         surface_.vertices()[corners[2]]}
    );
    std::vector<int> vertices(corners.begin(), corners.end());
    std::map<int, int> pointOf;
    const auto add = [&](int node) {
        pointOf.emplace(node, triangulation.addPoint(nodes_.placeIn(node, face)));
        vertices.push_back(vertexOf_[node]);
    };
    for (int k = 0; k < 3; ++k) {
        std::ranges::for_each(nodes_.onSide(face, k), add);
    }
    std::ranges::for_each(nodes_.inside(face), add);
    const auto pointAt = [&](int node) {
        const auto found = pointOf.find(node);
        return found != pointOf.end() ? found->second : cornerOf(corners, nodes_[node].element);
    };
    if (arrangement_.hasSegmentsIn(face)) {
        for (const ImprintSegment& segment : arrangement_.segmentsIn(face)) {
            triangulation.addSegment(pointAt(segment.a), pointAt(segment.b));
        }
    }
    std::vector<Triangle> children = triangulation.triangles();
    for (Triangle& child : children) {
        std::ranges::rotate(child, std::ranges::min_element(child));
    }
    std::ranges::sort(children);
    for (Triangle& child : children) {
        for (int& vertex : child) {
            vertex = vertices[vertex];
        }
    }
    return children;
}

/// Whether a child has area and its parent's orientation as its vertices are rounded.
bool Imprinter::isSound(int face, const Triangle& child) const {
    const auto at = [&](int vertex) -> const Vec3& {
        const int old = surface_.vertexCount();
        return vertex < old ? surface_.vertices()[vertex] : newPositions_[vertex - old];
    };
    const Triangle& corners = surface_.faces()[face];
    const Vec3 &a = at(corners[0]), &b = at(corners[1]), &c = at(corners[2]);
    const Vec3 normal = (b - a).cross(c - a);
    const Vec3 own = (at(child[1]) - at(child[0])).cross(at(child[2]) - at(child[0]));
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const int dropped = static_cast<int>(axis);
    const int sign = projectedOrientationSign(a, b, c, dropped);
    return projectedOrientationSign(at(child[0]), at(child[1]), at(child[2]), dropped) == sign &&
           normal.dot(own) > kLeastCosine * normal.norm() * own.norm();
}

ImprintedCurve Imprinter::imprintedCurve(const std::vector<CurvePiece>& pieces) const {
    std::vector<int> path{pieces.front().from};
    for (const CurvePiece& piece : pieces) {
        arrangement_.appendPath(piece.face, piece.from, piece.to, path);
    }
    ImprintedCurve curve;
    for (const int node : path) {
        const int vertex = vertexOf_[node];
        if (curve.vertices.empty() || curve.vertices.back() != vertex) {
            curve.vertices.push_back(vertex);
        }
    }
    return curve;
}

ImprintedMesh Imprinter::result() const {
    ImprintedMesh result;
    result.mesh.vertices.reserve(surface_.vertices().size() + newPositions_.size());
    result.mesh.vertices = surface_.vertices();
    result.mesh.vertices.insert(
        result.mesh.vertices.end(), newPositions_.begin(), newPositions_.end()
    );
    std::size_t more = 0;
    for (const auto& [face, children] : children_) {
        more += children.size() - 1;
        result.dividedFaces += children.size() > 1 ? 1 : 0;
    }
    result.mesh.faces.reserve(surface_.faces().size() + more);
    result.parents.reserve(surface_.faces().size() + more);
    const auto keepUntil = [&](int end) {
        const int begin = result.parents.empty() ? 0 : result.parents.back() + 1;
        result.mesh.faces.insert(
            result.mesh.faces.end(),
            surface_.faces().begin() + begin,
            surface_.faces().begin() + end
        );
        result.parents.resize(result.mesh.faces.size());
        std::iota(result.parents.end() - (end - begin), result.parents.end(), begin);
    };
    for (const auto& [face, children] : children_) {
        keepUntil(face);
        result.mesh.faces.insert(result.mesh.faces.end(), children.begin(), children.end());
        result.parents.resize(result.mesh.faces.size(), face);
    }
    keepUntil(surface_.faceCount());
    for (const int node : newNodes_) {
        result.newVertices.push_back(nodes_.surfacePoint(node));
    }
    std::set<std::pair<int, int>> edges;
    for (std::size_t c = 0; c < pieces_.size(); ++c) {
        ImprintedCurve curve = imprintedCurve(pieces_[c]);
        curve.closed = curves_[c].closed;
        if (curve.closed && curve.vertices.size() > 1 &&
            curve.vertices.front() == curve.vertices.back()) {
            curve.vertices.pop_back();
        }
        const std::size_t count = curve.vertices.size();
        for (std::size_t i = 0; i + 1 < count + (curve.closed ? 1 : 0); ++i) {
            edges.insert(std::minmax(curve.vertices[i], curve.vertices[(i + 1) % count]));
        }
        result.curves.push_back(std::move(curve));
    }
    std::map<int, int> meeting;
    for (const auto& [a, b] : edges) {
        ++meeting[a];
        ++meeting[b];
    }
    for (const auto& [vertex, count] : meeting) {
        if (count > 2) {
            result.crossings.push_back(vertex);
        }
    }
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

ImprintedMesh imprint(
    const Surface& surface, std::span<const SurfacePolyline> curves, const ImprintOptions& options
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
        const Imprinter imprinter(surface, curves, snap);
        if (imprinter.flatFaces().empty()) {
            return imprinter.result();
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
