// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve segment MESH --curve FILE …: labels and colours for the parts between curves.
#include "bspline_curve/error.h"
#include "cli/result_files.h"
#include "cli/use_input.h"
#include "cli/verb_parser.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"

namespace bspline_curve::cli {

namespace {

struct SegmentArguments : UseArguments {
    std::filesystem::path table;  ///< empty: none asked for
    ImprintRequest request;
};

struct SegmentParser {
    SegmentParser() {
        addMeshOutput(
            app,
            arguments.output,
            "Mesh to write, with the part of each face as `label`, quality and colour",
            "FILE.ply"
        );
        addFile(
            app,
            "--table",
            arguments.table,
            "Write faces, area, perimeter, centroid and Euler characteristic of each part: .csv or "
            ".json"
        );
        options.described.add("snap");
    }

    SegmentArguments finish() {
        options.finish();
        arguments.request = imprintRequest(options.described.values());
        return arguments;
    }

    CLI::App app{
        "Labels and colours the parts that curves leave, from the largest area (0) to the "
        "smallest. The\nmesh stays whole: curves become edges of it.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, curves that are not on this mesh or part "
        "nothing; 2\nwrong usage; 130 interrupted by Ctrl-C. No output is written unless the "
        "status is 0.\n",
        "bspline_curve segment"
    };
    SegmentArguments arguments;
    UseOptions options{app, arguments, segmentFilter()};
};

void checkTableExtension(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    if (extension != ".csv" && extension != ".json") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": tables are written as .csv or .json; change the name's end"
        );
    }
}

ExitCode segmentBy(const SegmentArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkHoldsLabels);
    checkOutput(arguments.table, checkTableExtension);
    const ImprintedFile file = imprintedFile(arguments, arguments.request, bar);
    const CutMeshes segments = segmentsOf(file.imprint, false);
    bar.show(kImprintedShare, "writing");
    ResultFiles files;
    files.add(arguments.output, file.bytesOf(arguments.output, segments.pieces.front().mesh, true));
    if (!arguments.table.empty()) {
        const bool isCsv = lowerCaseExtension(arguments.table) == ".csv";
        const MeshParts& parts = file.imprint.parts;
        files.add(arguments.table, isCsv ? partsCsv(parts) : partsJson(parts));
    }
    bar.clear();
    files.commit();
    printNotes(file.notesFor(arguments.output));
    printNotes(segments.notes);
    bar.tell(arguments.output, describeCount(file.imprint.parts.parts.size(), "part", "parts"));
    return ExitCode::Success;
}

}  // namespace

ExitCode runSegment(Arguments arguments) {
    return runParsed<SegmentParser>(arguments, segmentBy);
}

}  // namespace bspline_curve::cli
