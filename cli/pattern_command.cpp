// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve pattern MESH --drawing FILE --centre X,Y,Z …: a drawing as curves on the surface.
#include "bspline_curve/files.h"
#include "bspline_curve/pattern.h"
#include "cli/described_options.h"
#include "cli/loaded_mesh.h"
#include "cli/reports/curve_report.h"
#include "cli/reports/pattern_report.h"
#include "cli/result_files.h"
#include "cli/verb_parser.h"
#include "filters/pattern_requests.h"
#include "filters/utf8_path.h"
#include "text/error_messages.h"
#include "utility/stopwatch.h"

#include <optional>

namespace bspline_curve::cli {

namespace {

// Share of the progress, up to the end of preparing the mesh.
constexpr double kPatternPreparedShare = 0.3;

struct PatternArguments {
    std::filesystem::path mesh, output;
    std::filesystem::path drawing;  ///< empty: text
    std::filesystem::path font;
    std::filesystem::path along;   ///< empty: round a point
    std::filesystem::path report;  ///< empty: none asked for
    std::string text;
    std::vector<double> centre, up;   ///< empty: not said
    std::vector<std::string> layers;  ///< of a DXF; empty: all that are visible
    PatternRequest request;
    LengthUnit unit = LengthUnit::Millimetre;
};

struct PatternParser {
    PatternParser() {
        addFiles();
        addPlace();
        for (const char* const id : {"repeat", "spacing", "start", "shift", "max_distance"}) {
            options.add(id)->needs("--along");
        }
        options.add("direction", {.otherType = "X,Y,Z", .help = kDirectionHelp})->needs("--along");
        auto* const size = options.add("size");
        options.add("scale")->excludes(size);
        for (const char* const id :
             {"corner_angle", "smoothing", "tolerance", "strict", "weld", "slits"}) {
            options.add(id);
        }
        listIn(app, "Drawing", {"--drawing", "--layers", "--text", "--font"});
        listIn(app, "Place and size", {"--centre", "--up", "--size", "--scale"});
        listIn(
            app,
            "Along a curve",
            {"--along",
             "--repeat",
             "--spacing",
             "--start",
             "--shift",
             "--max-distance",
             "--direction"}
        );
    }

    PatternArguments finish() {
        if (arguments.centre.empty() == arguments.along.empty()) {
            throw CLI::ValidationError("one of --centre and --along is required");
        }
        if (arguments.drawing.empty() == arguments.text.empty()) {
            throw CLI::ValidationError("one of --drawing and --text is required");
        }
        options.set("drawing", arguments.drawing.string());
        options.set("text", arguments.text);
        arguments.request = patternRequest(options.values());
        return arguments;
    }

    void addFiles() {
        addMesh(app, arguments.mesh);
        addFile(app, "--drawing", arguments.drawing, "Planar drawing to carry: .svg or .dxf");
        addLayers(app, arguments.layers);
        app.add_option(
               "--text",
               arguments.text,
               "Text to carry in place of a drawing, as outlines of the letters of --font; one "
               "unit is the font's em, and the letters stand on the curve of --along"
        )
            ->type_name("TEXT")
            ->excludes("--drawing");
        addFile(
            app,
            "--font",
            arguments.font,
            "Font of --text: .ttf, .otf or .pfb; default: a plain one of this system"
        )
            ->needs("--text");
        addOutput(
            app,
            arguments.output,
            "Curves to write, all in one file: " + manyCurvesExtensions() +
                "; .json is what --curve of other verbs takes"
        );
        addUnit(app, arguments.unit);
        addReport(app, arguments.report, "Write counts, distortion, lengths and times");
    }

    void addPlace() {
        addVector(
            "--centre",
            arguments.centre,
            "Carry the drawing round this point, at most 1 % of the mesh's diagonal from it, where "
            "the middle of the drawing comes to lie"
        );
        addVector(
            "--up",
            arguments.up,
            "Direction in space that the drawing's up follows at the centre; default: the y axis, "
            "or z where the surface faces along y"
        )
            ->needs("--centre");
        addFile(
            app,
            "--along",
            arguments.along,
            "Carry the drawing along this curve on the mesh, in any format of --curve: its x axis "
            "along the curve, its y axis to the left, seen with the surface's normal upwards"
        );
    }

    CLI::Option* addVector(const char* flag, std::vector<double>& vector, const std::string& help) {
        return app.add_option(flag, vector, help)->delimiter(',')->expected(3)->type_name("X,Y,Z");
    }

    CLI::App app{
        "Carries a planar drawing to the surface, each path as curves through picks of their own: "
        "round a\npoint, along straightest geodesics from it (exponential map), or along a "
        "curve. Paths are parted\nat corners.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or a path that cannot be carried; 2 wrong "
        "usage; 130\ninterrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve pattern"
    };
    PatternArguments arguments;
    DescribedOptions options{app, patternFilter()};
};

Vec3 toVec3(const std::vector<double>& values) {
    return {values[0], values[1], values[2]};
}

SurfacePolyline curveAlong(const Workpiece& workpiece, const PatternArguments& arguments) {
    return CurveFileReader(
               workpiece,
               {.projection = arguments.request.use.placing.projection(),
                .remedy = "a larger --max-distance"}
    )
        .readOne(arguments.along);
}

Pattern patternOn(
    const Workpiece& workpiece,
    const Drawing& drawing,
    const PatternArguments& arguments,
    const Progress& progress
) {
    const PatternRequest& request = arguments.request;
    if (!arguments.along.empty()) {
        return patternAlongCurve(
            workpiece,
            drawing,
            curveAlong(workpiece, arguments),
            request.row,
            request.pattern,
            progress
        );
    }
    return patternRoundPoint(
        workpiece,
        drawing,
        toVec3(arguments.centre),
        arguments.up.empty() ? std::nullopt : std::optional(toVec3(arguments.up)),
        request.row.scale,
        request.pattern,
        progress
    );
}

/// What is to be drawn, with notes for people; `figures` keep the font of a text.
DrawingFile drawingOf(const PatternArguments& arguments, PatternFigures& figures) {
    if (arguments.text.empty()) {
        return readDrawing(arguments.drawing, arguments.layers);
    }
    const std::filesystem::path font = fontOrDefault(arguments.font);
    figures.font = utf8Text(font);
    DrawingFile file{.drawing = textOutlines(arguments.text, font), .notes = {}};
    if (arguments.font.empty()) {
        file.notes.push_back("the font is " + figures.font + "; --font chooses another");
    }
    return file;
}

ExitCode carry(const PatternArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkManyCurvesExtension);
    checkOutput(arguments.report, checkReportExtension);
    bar.show(0.0, "reading");
    PatternFigures figures;
    Stopwatch watch;
    const DrawingFile drawing = drawingOf(arguments, figures);
    const MendingOptions& mending = arguments.request.use.mending;
    LoadedMesh loaded = loadMesh(arguments.mesh, mending.strict);
    figures.readSeconds = watch.lap();
    constexpr bool kNoCache = true;
    loaded.prepareForCurves(
        {.mending = mending}, kNoCache, progressPart(bar, 0.0, kPatternPreparedShare)
    );
    bar.clear();
    printNotes(loaded.notes());
    figures.prepareSeconds = watch.lap();
    const Pattern pattern = patternOn(
        *loaded.workpiece, drawing.drawing, arguments, progressPart(bar, kPatternPreparedShare, 1.0)
    );
    figures.drawSeconds = watch.lap();
    std::vector<const Curve*> curves;
    for (const PatternCurve& each : pattern.curves) {
        curves.push_back(&each.curve);
    }
    ResultFiles files;
    files.add(
        arguments.output,
        curvesBytes(arguments.output, curves, loaded.workpiece->checksum(), arguments.unit)
    );
    if (!arguments.report.empty()) {
        files.add(arguments.report, patternReportBytes(pattern, figures));
    }
    bar.clear();
    printNotes(drawing.notes);
    files.commit();
    bar.tell(arguments.output, describeCount(curves.size(), "curve", "curves"));
    return ExitCode::Success;
}

}  // namespace

ExitCode runPattern(Arguments arguments) {
    return runParsed<PatternParser>(arguments, carry);
}

}  // namespace bspline_curve::cli
