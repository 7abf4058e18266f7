// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve pattern MESH --drawing FILE --centre X,Y,Z …: a drawing as curves on the surface.
#include "bspline_curve/designer.h"
#include "cli/command.h"
#include "cli/described_options.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/parse_with.h"
#include "cli/progress_bar.h"
#include "cli/value_checks.h"
#include "cli/verb.h"
#include "design/curve_on_given_mesh.h"
#include "design/designer_surface.h"
#include "design/mended_designer.h"
#include "filters/requests.h"
#include "filters/utf8_path.h"
#include "io/atomic_file.h"
#include "io/curve_reader.h"
#include "io/curve_writer.h"
#include "io/drawing_reader.h"
#include "io/font_search.h"
#include "io/pattern_report.h"
#include "io/report_writer.h"
#include "io/text_outlines.h"
#include "pattern/draw_pattern.h"
#include "utility/stopwatch.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

// Shares of the progress: up to the end of reading, and of preparing the mesh.
constexpr double kReadShare = 0.1;
constexpr double kPreparedShare = 0.3;

struct PatternArguments {
    std::filesystem::path mesh, output;
    std::filesystem::path drawing;  ///< empty: text
    std::string text;
    std::filesystem::path font;
    std::filesystem::path along;     ///< empty: round a point
    std::filesystem::path report;    ///< empty: none asked for
    std::vector<double> centre, up;  ///< empty: not given
    RowLayout row;
    PatternOptions pattern;
    MendingOptions mending;
};

CLI::Validator notNegative() {
    return atLeast(0.0).validator();
}

class PatternParser {
public:
    PatternParser() {
        addFiles();
        addPlace();
        addSize();
        for (const char* id : {"strict", "weld"}) {
            options_.add(id, kMainGroup);
        }
    }

    /// Throws CLI::ParseError.
    PatternArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        if (arguments_.centre.empty() == arguments_.along.empty()) {
            throw CLI::ValidationError("one of --centre and --along is required");
        }
        if (arguments_.drawing.empty() == arguments_.text.empty()) {
            throw CLI::ValidationError("one of --drawing and --text is required");
        }
        arguments_.mending = mendingOptions(options_.values());
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    void addFiles() {
        app_.add_option("MESH", arguments_.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
            ->required()
            ->type_name("");
        app_.add_option("--drawing", arguments_.drawing, "Planar drawing to carry: .svg or .dxf")
            ->type_name("FILE");
        app_.add_option(
                "--text",
                arguments_.text,
                "Text to carry in place of a drawing, as outlines of the letters of --font; one "
                "unit is the font's em, and the letters stand on the curve of --along"
        )
            ->type_name("TEXT")
            ->excludes("--drawing");
        app_.add_option(
                "--font",
                arguments_.font,
                "Font of --text: .ttf, .otf or .pfb; "
                "default: a plain one of this system"
        )
            ->type_name("FILE")
            ->needs("--text");
        app_.add_option(
                "--output",
                arguments_.output,
                "Curves to write, all in one file: " + manyCurvesExtensions() +
                    "; .json is what --curve of other verbs takes"
        )
            ->required()
            ->type_name("FILE");
        app_.add_option(
                "--report", arguments_.report, "Write counts, distortion, lengths and times"
        )
            ->type_name("FILE.json");
    }

    void addPlace() {
        app_.add_option(
                "--centre",
                arguments_.centre,
                "Carry the drawing round this point, at most 1 % of the mesh's diagonal from it, "
                "where the middle of the drawing comes to lie"
        )
            ->delimiter(',')
            ->expected(3)
            ->type_name("X,Y,Z");
        app_.add_option(
                "--up",
                arguments_.up,
                "Direction in space that the drawing's up follows at the centre; default: the y "
                "axis, or z where the surface faces along y"
        )
            ->delimiter(',')
            ->expected(3)
            ->type_name("X,Y,Z")
            ->needs("--centre");
        app_.add_option(
                "--along",
                arguments_.along,
                "Carry the drawing along this curve on the mesh, as this program writes it: its x "
                "axis along the curve, its y axis to the left, seen with the surface's normal "
                "upwards"
        )
            ->type_name("FILE.json");
        app_.add_option(
                "--repeat",
                arguments_.row.repeat,
                "Copies along the curve, evenly spaced; default: as many as --spacing says, or one"
        )
            ->check(Interval<int>{.low = 1, .high = 100000}.validator())
            ->type_name("N")
            ->needs("--along");
        app_.add_option(
                "--spacing",
                arguments_.row.spacing,
                "Length of the curve from one copy to the next; on a closed curve the nearest that "
                "divides its length"
        )
            ->check(notNegative())
            ->type_name("NUMBER")
            ->needs("--along");
        app_.add_option(
                "--start", arguments_.row.start, "Length of the curve before the first copy"
        )
            ->check(notNegative())
            ->type_name("NUMBER")
            ->needs("--along");
        app_.add_option(
                "--shift", arguments_.row.shift, "Move the drawing to the left of the curve"
        )
            ->type_name("NUMBER")
            ->needs("--along");
    }

    void addSize() {
        app_.add_option(
                "--size",
                arguments_.row.scale.size,
                "Longer side of the drawing, in the mesh's unit; default: 10 % of the mesh's "
                "diagonal, or along a curve so that copies touch"
        )
            ->check(notNegative())
            ->type_name("NUMBER");
        app_.add_option(
                "--scale",
                arguments_.row.scale.scale,
                "Units of the mesh for one of the drawing, in place of --size"
        )
            ->check(notNegative())
            ->type_name("NUMBER")
            ->excludes("--size");
        app_.add_option(
                "--corner-angle",
                arguments_.pattern.cornerAngle,
                "Part paths into curves where they turn by more than this, in degrees"
        )
            ->check(Interval<double>{.low = 0.0, .high = 179.0, .withLow = false}.validator())
            ->capture_default_str()
            ->type_name("NUMBER");
        app_.add_option(
                "--smoothing",
                arguments_.pattern.smoothing,
                "Smooth a copy of the mesh along its normals this often, and find the ways of the "
                "drawing on it: evens patterns on rough scans"
        )
            ->check(Interval<int>{.low = 0, .high = 1000}.validator())
            ->capture_default_str()
            ->type_name("N");
        app_.add_option(
                "--tolerance",
                arguments_.pattern.tolerance,
                "Largest distance of curves to the carried drawing, in the mesh's unit; default: "
                "0.1 % of the mean size of its paths"
        )
            ->check(notNegative())
            ->type_name("NUMBER");
    }

    CLI::App app_{
        "Carries a planar drawing to the surface, each path as curves through picks of their own: "
        "round a\npoint, along straightest geodesics from it (exponential map), or along a "
        "curve. Paths are parted\nat corners.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or a path that cannot be carried; 2 wrong "
        "usage; 130\ninterrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve pattern"
    };
    PatternArguments arguments_;
    DescribedOptions options_{app_, curveFilter()};
};

void checkFiles(const PatternArguments& arguments) {
    checkManyCurvesExtension(arguments.output);
    checkWritable(arguments.output);
    if (!arguments.report.empty()) {
        checkReportExtension(arguments.report);
        checkWritable(arguments.report);
    }
}

Vec3 toVec3(const std::vector<double>& values) {
    return {values[0], values[1], values[2]};
}

/// Drawn on what was made of the mesh, with the faces of the mesh as it was given.
Pattern patternOn(
    const Mended<CurveDesigner>& mended,
    const Drawing& drawing,
    const PatternArguments& arguments,
    const MeshChecksum& checksum,
    const Progress& progress
) {
    const CurveDesigner& designer = mended.made;
    Pattern pattern =
        arguments.along.empty()
            ? patternRoundPoint(
                  designer,
                  drawing,
                  toVec3(arguments.centre),
                  arguments.up.empty() ? std::nullopt : std::optional(toVec3(arguments.up)),
                  arguments.row.scale,
                  arguments.pattern,
                  progress
              )
            : patternAlongCurve(
                  designer,
                  drawing,
                  readCurve(arguments.along, surfaceOf(designer), checksum, mended.repair()),
                  arguments.row,
                  arguments.pattern,
                  progress
              );
    for (PatternCurve& each : pattern.curves) {
        bringBack(each.curve, mended.repair());
    }
    return pattern;
}

/// What is to be drawn, with notes for people; `figures` keep the font of a text.
DrawingFile drawingOf(const PatternArguments& arguments, PatternFigures& figures) {
    if (arguments.text.empty()) {
        return readDrawing(arguments.drawing);
    }
    const std::filesystem::path font = fontOrDefault(arguments.font);
    figures.font = utf8Text(font);
    DrawingFile file{.drawing = textOutlines(arguments.text, font), .notes = {}};
    if (arguments.font.empty()) {
        file.notes.push_back("the font is " + figures.font + "; --font chooses another");
    }
    return file;
}

ExitCode draw(const PatternArguments& arguments, ProgressBar& bar) {
    checkFiles(arguments);
    bar.show(0.0, "reading");
    PatternFigures figures;
    Stopwatch watch;
    const DrawingFile drawing = drawingOf(arguments, figures);
    MeshFile file = readInputMesh(arguments.mesh, arguments.mending.strict);
    const MeshChecksum checksum = checksumOf(file.mesh);
    figures.readSeconds = watch.lap();
    throwIfInterrupted();
    const Mended<CurveDesigner> mended = makeMendedDesigner(
        std::move(file.mesh), arguments.mending, {}, progressPart(bar, kReadShare, kPreparedShare)
    );
    bar.clear();
    sayMended(mended.mending);
    figures.prepareSeconds = watch.lap();
    const Pattern pattern = patternOn(
        mended, drawing.drawing, arguments, checksum, progressPart(bar, kPreparedShare, 1.0)
    );
    figures.drawSeconds = watch.lap();
    std::vector<const Curve*> curves;
    for (const PatternCurve& each : pattern.curves) {
        curves.push_back(&each.curve);
    }
    // Both files appear, or none.
    std::list<AtomicFile> files;
    files.emplace_back(arguments.output, curvesBytes(arguments.output, curves, checksum));
    if (!arguments.report.empty()) {
        files.emplace_back(arguments.report, patternReportBytes(pattern, figures));
    }
    bar.clear();
    for (const std::string& note : drawing.notes) {
        printError("note: " + note);
    }
    beginWriting();
    for (AtomicFile& each : files) {
        each.commit();
    }
    return ExitCode::Success;
}

}  // namespace

ExitCode runPattern(Arguments arguments) {
    const auto parsed = parseWith<PatternParser>(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& asked = std::get<PatternArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return draw(asked, bar); });
}

}  // namespace bspline_curve::cli
