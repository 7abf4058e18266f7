// SPDX-License-Identifier: GPL-3.0-or-later
#include "tetrahedra/conforming_tetrahedra.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "shell/affine_form.h"
#include "surface/predicates.h"
#include "surface/surface_point.h"
#include "tetrahedra/facet_complex.h"
#include "text/error_messages.h"

#include <tetgen.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

[[noreturn]] void refuse(const std::string& reason, const std::vector<std::int64_t>& faces = {}) {
    throw InputError(
        InputErrorCode::NoShell,
        "TetGen cannot make tetrahedra that conform to the surface: " + reason +
            "; take a full shell (--shell full), whose tetrahedra conform to it, or simplify less "
            "(a smaller --target-thickness)",
        faces
    );
}

std::string reasonOf(int error) {
    switch (error) {
        case 1:
            return "it ran out of memory";
        case 4:
            return "it finds features too small for its tolerance";
        case 5:
            return "it finds faces closer than its tolerance";
        default:
            return "it stopped with its error " + std::to_string(error);
    }
}

/// The facets of the complex: the boundary of the shell first, then the surface.
struct Facets {
    FacetComplex complex;
    std::vector<BoundaryPart> boundary;  ///< for each of its facets
    std::vector<int> faces;              ///< of the surface, for each of its facets

    [[nodiscard]] int boundaryCount() const { return static_cast<int>(boundary.size()); }

    [[nodiscard]] bool isSurface(int facet) const { return facet >= boundaryCount(); }
};

Facets facetsOf(
    const ExtendedSurface& extended, const Shell& shell, std::span<const int> blockedFaces
) {
    Facets facets;
    for (int v = 0; v < extended.surfaceVertexCount; ++v) {
        facets.complex.reservePoint(extended.vertices[v]);
    }
    facets.boundary = addShellBoundary(shell, facets.complex);
    facets.faces = addSurfaceFaces(extended, blockedFaces, facets.complex);
    return facets;
}

using Tetrahedron = std::array<int, 4>;

/// What TetGen made, cavities included.
struct Filling {
    std::vector<Vec3> points;
    std::vector<Tetrahedron> tetrahedra;
    std::vector<Tetrahedron> neighbours;  ///< opposite to corner k; -1 where there is none
    /// The facet that a triangle of sorted points is part of.
    std::map<Triangle, int> facets;

    [[nodiscard]] std::optional<int> facetOpposite(int tet, int k) const {
        Triangle face{};
        for (std::size_t j = 0; j < 3; ++j) {
            face[j] = tetrahedra[tet][(static_cast<std::size_t>(k) + 1 + j) % 4];
        }
        std::ranges::sort(face);
        const auto found = facets.find(face);
        return found == facets.end() ? std::nullopt : std::optional(found->second);
    }
};

/// Refuses what TetGen would not survive, so before it starts.
void checkFacets(const Facets& facets) {
    if (facets.complex.shortestEdge() < kLeastTetgenEdge) {
        refuse("an edge of surface or shell is shorter than a millionth of the diagonal");
    }
    tetgenio found;  // -d: only look for facets that intersect
    if (const int error = facets.complex.runTetgen("pdQX1", found); error != 0) {
        refuse(reasonOf(error));
    }
    if (found.numberoftrifaces == 0) {
        return;
    }
    std::vector<std::int64_t> faces;
    for (int i = 0; i < found.numberoftrifaces; ++i) {
        const int facet = found.trifacemarkerlist[i] - 1;
        if (facets.isSurface(facet)) {
            faces.push_back(facets.faces[facet - facets.boundaryCount()]);
        }
    }
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
    std::string where = "it finds parts of the shell that intersect";
    if (!faces.empty()) {
        where = "it finds faces of the surface that intersect the shell or each other, ";
        where += describeElements(faces);
    }
    refuse(where, faces);
}

Filling fill(const FacetComplex& complex) {
    // -Y: facets stay whole; -n: neighbours; -X1: no static filter, whose bound would hold for one
    // box only; -Q: quiet.
    tetgenio output;
    if (const int error = complex.runTetgen("pYnQX1", output); error != 0) {
        refuse(reasonOf(error));
    }
    Filling filling;
    for (int i = 0; i < output.numberofpoints; ++i) {
        filling.points.emplace_back(Eigen::Map<const Vec3>(output.pointlist + 3 * i));
    }
    for (int i = 0; i < output.numberoftetrahedra; ++i) {
        Tetrahedron corners{};
        Tetrahedron beside{};
        std::copy_n(output.tetrahedronlist + output.numberofcorners * i, 4, corners.begin());
        std::copy_n(output.neighborlist + 4 * i, 4, beside.begin());
        filling.tetrahedra.push_back(corners);
        filling.neighbours.push_back(beside);
    }
    for (int i = 0; i < output.numberoftrifaces; ++i) {
        Triangle face{};
        std::copy_n(output.trifacelist + 3 * i, 3, face.begin());
        std::ranges::sort(face);
        if (output.trifacemarkerlist[i] > 0) {
            filling.facets.emplace(face, output.trifacemarkerlist[i] - 1);
        }
    }
    return filling;
}

/// On which side of its facet each tetrahedron beside the surface or the boundary is.
class SideFinder {
public:
    SideFinder(const Facets& facets, const Filling& filling)
        : facets_(facets),
          filling_(filling),
          isInside_(filling.tetrahedra.size(), false),
          sides_(filling.tetrahedra.size()) {}

    /// The side of each tetrahedron; none for those in cavities of the shell.
    std::vector<std::optional<SurfaceSide>> find() {
        std::deque<int> inside;
        std::deque<int> sided;
        std::vector<std::pair<int, BoundaryPart>> atBoundary;
        for (int tet = 0; tet < static_cast<int>(filling_.tetrahedra.size()); ++tet) {
            for (int k = 0; k < 4; ++k) {
                const auto facet = filling_.facetOpposite(tet, k);
                if (!facet) {
                    continue;
                }
                const bool isInFront = liesInFront(tet, k, *facet);
                if (facets_.isSurface(*facet)) {
                    sides_[tet] = isInFront ? SurfaceSide::Above : SurfaceSide::Below;
                    sided.push_back(tet);
                    enter(tet, inside);
                } else if (!isInFront) {  // boundary facets look outwards
                    enter(tet, inside);
                    atBoundary.emplace_back(tet, facets_.boundary[*facet]);
                }
            }
        }
        for (const auto& [tet, part] : atBoundary) {
            if (part != BoundaryPart::Wall && !sides_[tet]) {
                sides_[tet] = part == BoundaryPart::Top ? SurfaceSide::Above : SurfaceSide::Below;
                sided.push_back(tet);
            }
        }
        spread(inside, [&](int, int next) {
            const bool isNew = !isInside_[next];
            isInside_[next] = true;
            return isNew;
        });
        spread(sided, [&](int tet, int next) {
            const bool isNew = isInside_[next] && !sides_[next];
            if (isNew) {
                sides_[next] = sides_[tet];
            }
            return isNew;
        });
        return std::move(sides_);
    }

private:
    void enter(int tet, std::deque<int>& inside) {
        if (!isInside_[tet]) {
            isInside_[tet] = true;
            inside.push_back(tet);
        }
    }

    [[nodiscard]] bool liesInFront(int tet, int k, int facet) const {
        const auto& [a, b, c] = facets_.complex.triangles()[facet];
        const auto corner = static_cast<std::size_t>(k);
        const int sign = orientationSign(
            filling_.points[a],
            filling_.points[b],
            filling_.points[c],
            filling_.points[filling_.tetrahedra[tet][corner]]
        );
        if (sign == 0) {
            refuse(
                "it makes a flat tetrahedron, where surface and shell are too near to each other"
            );
        }
        return sign > 0;
    }

    /// Visits the neighbours of what is in the queue, not through facets; `enters` says whether to
    /// go on from there.
    template <class Enters>
    void spread(std::deque<int>& queue, const Enters& enters) {
        while (!queue.empty()) {
            const int tet = queue.front();
            queue.pop_front();
            for (int k = 0; k < 4; ++k) {
                const int next = filling_.neighbours[tet][static_cast<std::size_t>(k)];
                if (next >= 0 && !filling_.facetOpposite(tet, k) && enters(tet, next)) {
                    queue.push_back(next);
                }
            }
        }
    }

    const Facets& facets_;
    const Filling& filling_;
    std::vector<bool> isInside_;
    std::vector<std::optional<SurfaceSide>> sides_;
};

/// f of the shell at points of it.
class HeightFinder {
public:
    HeightFinder(const ExtendedSurface& extended, const Shell& shell)
        : extended_(extended), shell_(shell) {
        for (const Pillar& pillar : shell.pillars()) {
            at(pillar.bottom) = -1.0;
            at(pillar.middle) = 0.0;
            at(pillar.top) = 1.0;
        }
        for (int f = 0; f < extended.surfaceFaceCount; ++f) {
            for (const int v : extended.faces[f]) {
                faceOfVertex_.try_emplace(v, f);
            }
        }
    }

    /// `vertex`: of the surface, or -1.
    [[nodiscard]] double find(const Vec3& point, int vertex) const {
        const auto known = heights_.find({point[0], point[1], point[2]});
        if (known != heights_.end()) {
            return known->second;
        }
        const auto face = faceOfVertex_.find(vertex);
        if (face != faceOfVertex_.end()) {
            const int corner = cornerOf(extended_.faces[face->second], vertex);
            const int tet = shell_.locate({face->second, Vec3::Unit(corner)});
            if (tet >= 0) {
                return heightIn(tet, point).second;
            }
        }
        return heightInDeepest(point);
    }

private:
    double& at(const Vec3& point) { return heights_[{point[0], point[1], point[2]}]; }

    /// Least barycentric coordinate, and f.
    [[nodiscard]] std::pair<double, double> heightIn(int tet, const Vec3& point) const {
        std::array<AffineForm, 4> forms;
        shell_.barycentrics(tet, forms.data());
        const double outer = tet % kTetrahedraPerPrism < 3 ? 1.0 : -1.0;
        double least = std::numeric_limits<double>::infinity();
        double height = 0.0;
        const auto& split = kSlabSplit[static_cast<std::size_t>(tet % 3)];
        for (std::size_t k = 0; k < 4; ++k) {
            const double weight = forms[k].at(point);
            least = std::min(least, weight);
            height += split[k].outer ? outer * weight : 0.0;
        }
        return {least, std::clamp(height, -1.0, 1.0)};
    }

    /// Of all tetrahedra: few points are neither on the surface nor on the boundary.
    [[nodiscard]] double heightInDeepest(const Vec3& point) const {
        std::pair best{-std::numeric_limits<double>::infinity(), 0.0};
        for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
            if (shell_.prisms()[tet / kTetrahedraPerPrism].orientation != 0) {
                best = std::max(best, heightIn(tet, point), [](const auto& a, const auto& b) {
                    return a.first < b.first;
                });
            }
        }
        return best.second;
    }

    const ExtendedSurface& extended_;
    const Shell& shell_;
    std::map<std::array<double, 3>, double> heights_;
    std::map<int, int> faceOfVertex_;
};

/// In the user's unit; vertices of the surface that the shell did not move, exactly.
std::vector<Vec3> userPoints(
    const Surface& surface, const ExtendedSurface& extended, const std::vector<Vec3>& points
) {
    std::vector<Vec3> result;
    result.reserve(points.size());
    for (const Vec3& point : points) {
        result.push_back(extended.frame.toUser(point));
    }
    for (int v = 0; v < extended.surfaceVertexCount; ++v) {
        if (!std::ranges::binary_search(extended.movedVertices, v)) {
            result[v] = surface.vertices()[v];
        }
    }
    return result;
}

}  // namespace

ConformingTetrahedra conformToSurface(
    const Surface& surface,
    const ExtendedSurface& extended,
    const Shell& shell,
    std::span<const int> blockedFaces,
    const Progress& progress
) {
    constexpr double kChecked = 0.3;  // for the progress only
    constexpr double kFilled = 0.9;
    constexpr const char* kStage = "tetrahedra";
    report(progress, 0.0, kStage);
    const Facets facets = facetsOf(extended, shell, blockedFaces);
    checkFacets(facets);
    report(progress, kChecked, kStage);
    const Filling filling = fill(facets.complex);
    report(progress, kFilled, kStage);
    const auto sides = SideFinder(facets, filling).find();
    ConformingTetrahedra result;
    result.points = userPoints(surface, extended, filling.points);
    const HeightFinder heights(extended, shell);
    for (int i = 0; i < static_cast<int>(filling.points.size()); ++i) {
        const int vertex = i < extended.surfaceVertexCount ? i : -1;
        result.heights.push_back(heights.find(filling.points[i], vertex));
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::optional<SurfaceSide>& side = sides[i];
        if (!side) {
            continue;
        }
        Tetrahedron corners = filling.tetrahedra[i];
        const auto& [a, b, c, d] = corners;
        if (orientationSign(
                filling.points[a], filling.points[b], filling.points[c], filling.points[d]
            ) < 0) {
            std::swap(corners[0], corners[1]);
        }
        result.tetrahedra.push_back(corners);
        result.sides.push_back(*side);
    }
    report(progress, 1.0, kStage);
    return result;
}

}  // namespace bspline_curve
