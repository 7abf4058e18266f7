// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve segment MESH --curve FILE …: labels and colours for the parts between curves.
#include "bspline_curve/error.h"
#include "cli/command.h"
#include "cli/imprint_input.h"
#include "cli/interrupt.h"
#include "cli/parse_with.h"
#include "cli/progress_bar.h"
#include "cli/verb.h"
#include "imprint/part_choice.h"
#include "imprint/part_colours.h"
#include "io/atomic_file.h"
#include "io/imprint_writer.h"
#include "io/mesh_writer.h"
#include "io/text_parsing.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <list>
#include <string>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct SegmentArguments {
    ImprintInput input;
    std::filesystem::path output;
    std::filesystem::path table;  ///< empty: none asked for
};

class SegmentParser {
public:
    SegmentParser() {
        app_.add_option(
                "--output",
                arguments_.output,
                "Mesh to write, with the part of each face as `label`, quality and colour"
        )
            ->required()
            ->type_name("FILE.ply");
        app_.add_option(
                "--table",
                arguments_.table,
                "Write faces, area, perimeter, centroid and Euler characteristic of each part: "
                ".csv or .json"
        )
            ->type_name("FILE");
    }

    /// Throws CLI::ParseError.
    SegmentArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        input_.finish();
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    CLI::App app_{
        "Labels and colours the parts that curves leave, from the largest area (0) to the "
        "smallest. The\nmesh stays whole: curves become edges of it.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, curves that are not on this mesh or part "
        "nothing; 2\nwrong usage; 130 interrupted by Ctrl-C. No output is written unless the "
        "status is 0.\n",
        "bspline_curve segment"
    };
    SegmentArguments arguments_;
    ImprintInputOptions input_{app_, arguments_.input};
};

void checkExtension(
    const std::filesystem::path& file, const std::vector<std::string>& known, const char* what
) {
    const std::string extension = lowerCaseExtension(file);
    std::string names;
    for (const std::string& each : known) {
        if (extension == each) {
            return;
        }
        names += (names.empty() ? "" : " or ") + each;
    }
    throw InputError(
        InputErrorCode::UnwritableFile,
        file.string() + ": " + what + " as " + names + "; change the name's end"
    );
}

ExitCode segmentBy(const SegmentArguments& arguments, ProgressBar& bar) {
    checkExtension(arguments.output, {".ply"}, "labels of faces are written");
    checkWritable(arguments.output);
    if (!arguments.table.empty()) {
        checkExtension(arguments.table, {".csv", ".json"}, "tables are written");
        checkWritable(arguments.table);
    }
    const ImprintedFile file = readAndImprint(arguments.input, bar);
    const auto& [imprinted, origins, parts, inputQuality, quality, figures] = file;
    if (partedParts(imprinted, parts).empty()) {
        refuseNothingParted();
    }
    throwIfInterrupted();
    bar.show(0.7, "writing");
    std::vector<std::array<std::uint8_t, 3>> colours;
    for (const int label : parts.labels) {
        colours.push_back(partColour(label));
    }
    // All files appear, or none.
    std::list<AtomicFile> files;
    files.emplace_back(
        arguments.output,
        meshBytes(
            arguments.output,
            imprinted.mesh,
            {.vertexQuality = quality, .faceLabels = parts.labels, .faceColours = colours}
        )
    );
    if (!arguments.table.empty()) {
        files.emplace_back(
            arguments.table,
            lowerCaseExtension(arguments.table) == ".csv" ? partsCsv(parts) : partsJson(parts)
        );
    }
    bar.clear();
    beginWriting();
    for (AtomicFile& each : files) {
        each.commit();
    }
    saySlits(imprinted, parts, false);
    return ExitCode::Success;
}

}  // namespace

ExitCode runSegment(Arguments arguments) {
    const auto parsed = parseWith<SegmentParser>(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& asked = std::get<SegmentArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return segmentBy(asked, bar); });
}

}  // namespace bspline_curve::cli
