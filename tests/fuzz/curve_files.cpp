// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "bspline_curve/mesh.h"
#include "filters/drawn_curve_file.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "io/byte_stream.h"
#include "io/curve_reader.h"
#include "io/picks_formats.h"
#include "io/shell_file.h"
#include "shell/extended_surface.h"
#include "support/meshes.h"
#include "surface/strict_line.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

namespace bspline_curve::fuzz {

void readPicksBytes(std::string_view bytes) {
    if (bytes.empty()) {
        return;
    }
    const std::string rest(bytes.substr(1));
    try {
        PicksFile read;
        switch (static_cast<unsigned char>(bytes[0]) % 6) {
            case 0:
                read = picksOfPickPoints("file", rest);
                break;
            case 1:
                read = picksOfJson("file", rest);
                break;
            case 2:
                read = picksOfText("file", rest);
                break;
            case 3:
                read = picksOfCsv("file", rest);
                break;
            case 4:
                read = picksOfSlicerList("file", rest);
                break;
            default:
                read.picks = parsePicksText(rest);
                break;
        }
        require(
            std::ranges::all_of(read.picks, [](const Vec3& pick) { return pick.allFinite(); }),
            "picks are finite"
        );
    } catch (const InputError&) {
        return;
    }
}

namespace {

/// A mesh that curves are read on.
struct CurveMesh {
    MeshChecksum checksum;
    Workpiece workpiece;

    explicit CurveMesh(const TriangleMesh& mesh) : checksum(checksumOf(mesh)), workpiece(mesh) {}
};

/// The sphere with a face turned over and another one twice.
TriangleMesh brokenSphere() {
    TriangleMesh mesh = test_support::withFaceReversed(test_support::icosphere(0), 1);
    mesh.faces.push_back(mesh.faces[0]);
    return mesh;
}

const std::array<CurveMesh, 2>& curveMeshes() {
    static const std::array<CurveMesh, 2> kMeshes{
        CurveMesh(test_support::icosphere(0)), CurveMesh(brokenSphere())
    };
    return kMeshes;
}

}  // namespace

void readCurveBytes(std::string_view bytes) {
    const FuzzFile file("curve.json", bytes);
    for (const auto& [checksum, workpiece] : curveMeshes()) {
        try {
            const Surface& surface = surfaceOf(workpiece);
            const SurfacePolyline line = readCurve(file.path(), surface, checksum);
            require(
                isStrict(surface, strictLine(surface, line, "it")), "every segment lies in a face"
            );
        } catch (const InputError&) {
            continue;
        }
    }
}

void readForeignCurveBytes(std::string_view bytes) {
    if (bytes.empty()) {
        return;
    }
    constexpr std::array kNames{"a.ply", "a.obj", "a.dxf", "a.vtu", "a.csv"};
    const FuzzFile file(
        kNames[static_cast<unsigned char>(bytes[0]) % kNames.size()], bytes.substr(1)
    );
    for (const auto& [checksum, workpiece] : curveMeshes()) {
        const Surface& surface = surfaceOf(workpiece);
        try {
            CurveFileReader curves(workpiece, {.projection = {.distance = surface.diagonal()}});
            for (const SurfacePolyline& line : curves.read(file.path()).lines) {
                require(
                    isStrict(surface, strictLine(surface, line, "it")),
                    "every segment lies in a face"
                );
            }
        } catch (const InputError&) {
            continue;
        }
    }
}

void readDrawingBytes(std::string_view bytes) {
    if (bytes.empty()) {
        return;
    }
    constexpr std::array kNames{"a.svg", "a.dxf"};
    const FuzzFile file(
        kNames[static_cast<unsigned char>(bytes[0]) % kNames.size()], bytes.substr(1)
    );
    try {
        for (const DrawingPath& path : readDrawing(file.path()).drawing.paths) {
            require(!path.arcs.empty(), "paths have arcs");
        }
    } catch (const InputError&) {
        return;
    }
}

void openDrawnBytes(std::string_view bytes) {
    if (bytes.empty()) {
        return;
    }
    constexpr std::array kNames{"curves.json", "curves.obj", "curves.dxf"};
    const FuzzFile file(
        kNames[static_cast<unsigned char>(bytes[0]) % kNames.size()], bytes.substr(1)
    );
    for (const auto& [checksum, workpiece] : curveMeshes()) {
        const TriangleMesh& mesh = workpiece.mesh();
        const CurveFileSurface surface{.mesh = mesh, .checksum = checksum, .workpiece = &workpiece};
        try {
            for (const DrawnCurve& curve : openDrawnCurves(file.path(), surface).curves) {
                for (const SketchPick& pick : curve.picks) {
                    const double gap = (positionOf(mesh, pick.point) - pick.position).norm();
                    require(gap < 1e-5, "picks are on the surface");
                }
                static_cast<void>(valuesOf(curve.options));
            }
        } catch (const InputError&) {
            continue;
        }
    }
}

void readShellBytes(std::string_view bytes) {
    static const Surface kSurface(test_support::icosphere(0));
    static const auto kExtended =
        std::make_shared<const ExtendedSurface>(extendSurface(kSurface, 3));
    // Damage never has the right checksum; with it, what is behind the check is tried as well.
    constexpr std::size_t kChecksumBytes = 8;
    std::string sealed(bytes.substr(0, bytes.size() - std::min(bytes.size(), kChecksumBytes)));
    std::uint64_t checksum = checksumOf(std::string_view(sealed));
    for (std::size_t i = 0; i < kChecksumBytes; ++i) {
        sealed += static_cast<char>(checksum & 0xffU);
        checksum >>= 8U;
    }
    for (const std::string_view each : {bytes, std::string_view(sealed)}) {
        try {
            const ShellBuild build = decodeShell("file", each, kSurface, kExtended, "parameters");
            require(!build.shell.prisms().empty(), "a shell has prisms");
        } catch (const InputError&) {
            continue;
        }
    }
}

}  // namespace bspline_curve::fuzz
