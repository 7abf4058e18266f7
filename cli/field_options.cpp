// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/field_options.h"

#include "bspline_curve/error.h"
#include "cli/described_options.h"
#include "cli/mesh_input.h"
#include "cli/parse_with.h"
#include "filters/requests.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace bspline_curve::cli {

namespace {

constexpr const char* kPrefix = "--";

/// The command line of one field, and what was given on it.
class FieldParser {
public:
    FieldParser() {
        app_.add_option("MESH", arguments_.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
            ->required()
            ->type_name("");
        options_.add("kind", kMainGroup, {.isRequired = true});
        app_.add_option(
                "--output",
                arguments_.output,
                "Field to write: .ply (the mesh with the field as per-vertex quality), .npy or .txt"
        )
            ->required()
            ->type_name("FILE");
        app_.add_option(
                "--report",
                arguments_.report,
                "Write minimum, mean and maximum of the field, and times, as .json"
        )
            ->type_name("FILE.json");
        for (const ParameterDescription& parameter : fieldFilter().parameters) {
            // The region is a selection elsewhere; here it is a file or a threshold.
            if (parameter.id != "kind" && parameter.id != "region") {
                options_.add(parameter.id, kMainGroup);
            }
        }
        addRegionOptions(app_, kMainGroup, kPrefix, arguments_.region);
        addRepairOption(app_);
    }

    /// Throws CLI::ParseError, InputError (BadOption).
    FieldArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        const FieldRequest request = fieldRequest(options_.values());
        arguments_.field = request.options;
        arguments_.mending = request.mending;
        checkRegion(arguments_.region, arguments_.field.kind, kPrefix);
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    CLI::App app_{
        "Computes a field on a triangle mesh, one value per vertex, that curves can follow or "
        "avoid:\n"
        "give it to a curve by --field, or look at it in MeshLab.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or nothing there to make the field from; 2 "
        "wrong\n"
        "usage; 130 interrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve field"
    };
    FieldArguments arguments_;
    DescribedOptions options_{app_, fieldFilter()};
};

}  // namespace

std::variant<FieldArguments, ExitCode> parseFieldArguments(Arguments arguments) {
    return parseWith<FieldParser>(arguments);
}

}  // namespace bspline_curve::cli
