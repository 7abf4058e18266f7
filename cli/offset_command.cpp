// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve offset MESH --curve FILE --distance D …: curves beside a curve.
#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/numbered_file.h"
#include "cli/parse_with.h"
#include "cli/progress_bar.h"
#include "cli/value_checks.h"
#include "cli/verb.h"
#include "io/atomic_file.h"
#include "io/curve_reader.h"
#include "io/curve_writer.h"
#include "io/mesh_writer.h"
#include "io/text_parsing.h"
#include "offset/offset_curves.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct OffsetArguments {
    std::filesystem::path mesh, curve, output;
    std::filesystem::path band;  ///< empty: none asked for
    OffsetOptions offset;
};

class OffsetParser {
public:
    OffsetParser() {
        app_.add_option("MESH", arguments_.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
            ->required()
            ->type_name("");
        app_.add_option(
                "--curve", arguments_.curve, "Curve on this mesh, as this program writes it: .json"
        )
            ->required()
            ->type_name("FILE.json");
        app_.add_option(
                "--distance",
                arguments_.offset.distance,
                "Distance from the curve along the surface, in the mesh's unit"
        )
            ->required()
            ->check(
                Interval<double>{
                    .low = 0.0, .high = std::numeric_limits<double>::max(), .withLow = false
                }
                    .validator()
            )
            ->type_name("NUMBER");
        app_.add_option(
                "--side",
                side_,
                "left, right (seen along the curve, the surface's normal upwards) or both, which "
                "runs round the ends of an open curve"
        )
            ->check(oneOf({"left", "right", "both"}))
            ->capture_default_str()
            ->type_name("SIDE");
        app_.add_option(
                "--output",
                arguments_.output,
                "Offset to write: " + curveExtensions() +
                    "; where it has several pieces, the longest first, further ones are "
                    "FILE-2.ply, FILE-3.ply, …"
        )
            ->required()
            ->type_name("FILE");
        app_.add_option(
                "--band",
                arguments_.band,
                "Write the mesh with 1 for each face whose middle is within the distance, on the "
                "side asked for, else 0, as label and quality of faces"
        )
            ->type_name("FILE.ply");
    }

    /// Throws CLI::ParseError.
    OffsetArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        arguments_.offset.sides = side_ == "left"    ? OffsetSides::Left
                                  : side_ == "right" ? OffsetSides::Right
                                                     : OffsetSides::Both;
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    CLI::App app_{
        "Draws the lines at a distance from a curve, measured along the surface. Where an offset "
        "runs\ninto itself it ends there, so that no piece crosses itself or another.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or no point has that distance; 2 wrong usage; "
        "130\ninterrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve offset"
    };
    OffsetArguments arguments_;
    std::string side_ = "both";
};

ExitCode draw(const OffsetArguments& arguments, ProgressBar& bar) {
    checkCurveExtension(arguments.output);
    checkWritable(arguments.output);
    if (!arguments.band.empty()) {
        if (lowerCaseExtension(arguments.band) != ".ply") {
            throw InputError(
                InputErrorCode::UnwritableFile,
                arguments.band.string() +
                    ": labels of faces are written as .ply; change the "
                    "name's end"
            );
        }
        checkWritable(arguments.band);
    }
    bar.show(0.0, "reading");
    constexpr bool kStrict = true;  // nothing is mended here
    const Surface surface(readInputMesh(arguments.mesh, kStrict).mesh);
    const MeshChecksum checksum = checksumOf(surface.mesh());
    const SurfacePolyline curve = readCurve(arguments.curve, surface, checksum);
    if (interrupted()) {
        throw Cancelled();
    }
    bar.show(0.3, "measuring distances");
    const std::vector<SurfacePolyline> pieces = offsetPolylines(surface, curve, arguments.offset);
    if (pieces.empty()) {
        throw InputError(
            InputErrorCode::NoPath,
            "no point of the surface on that side is at this distance from the curve; give a "
            "smaller --distance"
        );
    }
    if (interrupted()) {
        throw Cancelled();
    }
    // All files appear, or none.
    std::list<AtomicFile> files;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::filesystem::path file = numberedFile(arguments.output, i);
        const Curve piece{
            .polyline = pieces[i], .spline = polygonSpline(pieces[i]), .report = {}, .shell = {}
        };
        files.emplace_back(file, curveBytes(file, piece, {}, checksum));
    }
    if (!arguments.band.empty()) {
        const std::vector<char> within = facesWithin(surface, curve, arguments.offset);
        const std::vector<int> labels(within.begin(), within.end());
        files.emplace_back(
            arguments.band, meshBytes(arguments.band, surface.mesh(), {.faceLabels = labels})
        );
    }
    bar.clear();
    for (AtomicFile& file : files) {
        file.commit();
    }
    if (pieces.size() > 1) {
        std::cerr << "bspline_curve: the offset has " << pieces.size() << " pieces, the last in "
                  << numberedFile(arguments.output, pieces.size() - 1).string() << '\n';
    }
    return ExitCode::Success;
}

}  // namespace

ExitCode runOffset(Arguments arguments) {
    const auto parsed = parseWith<OffsetParser>(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& offset = std::get<OffsetArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return draw(offset, bar); });
}

}  // namespace bspline_curve::cli
