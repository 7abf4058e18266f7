// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/field_options.h"

#include "cli/mesh_input.h"
#include "cli/parse_with.h"
#include "surface/input_error.h"

#include <string>
#include <vector>

namespace bspline_curve::cli {

namespace {

constexpr const char* kMain = "Options";
constexpr const char* kPrefix = "--";

/// The command line of one field, and what was given on it.
class FieldParser {
public:
    FieldParser() {
        app_.add_option("MESH", arguments_.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
            ->required()
            ->type_name("");
        app_.add_option("--kind", kind_, "What the values are made from")
            ->required()
            ->check(oneOf(fieldKindNames()))
            ->type_name(joined(fieldKindNames()));
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
        addFieldOptions(table_, kPrefix);
        addRegionOptions(app_, kMain, kPrefix, arguments_.region);
        addRepairOption(app_, arguments_.repair);
    }

    /// Throws CLI::ParseError, InputError (BadOption).
    FieldArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        table_.apply(arguments_.field);
        // The check let only names pass.
        arguments_.field.kind = findFieldKind(kind_).value_or(FieldKind::Quality);
        checkRegion(arguments_.region, arguments_.field.kind, kPrefix);
        arguments_.field.validate();
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
    std::string kind_;
    OptionTable<FieldOptions> table_{app_, kMain};
};

}  // namespace

std::variant<FieldArguments, ExitCode> parseFieldArguments(Arguments arguments) {
    return parseWith<FieldParser>(arguments);
}

}  // namespace bspline_curve::cli
