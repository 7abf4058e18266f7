// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "cli/manual.h"
#include "cli/value_checks.h"
#include "cli/verb.h"

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Command lines of verbs. A parser has the members `app`, a CLI::App that its constructor fills,
// and `finish()`, which returns what was said, after parsing; it may throw as that.
namespace bspline_curve::cli {

/// Lists those of the options that a verb has in a group of its help.
inline void listIn(CLI::App& app, const char* group, std::initializer_list<const char*> flags) {
    for (const char* const flag : flags) {
        if (CLI::Option* const option = app.get_option_no_throw(flag)) {
            option->group(group);
        }
    }
}

/// Throws CLI::ParseError, InputError (BadOption).
template <class Parser>
auto parsedBy(Parser& parser, Arguments words) {
    // CLI11 takes them in reverse order.
    parser.app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    return parser.finish();
}

/// A verb: reads its command line and does the work that it asks for; where it is wrong, or asks
/// for help, that is printed.
template <class Parser, class Parsed>
[[nodiscard]] ExitCode runParsed(
    Arguments words,
    ExitCode (*work)(Parsed& arguments, ProgressBar& bar),
    AfterInterrupt after = AfterInterrupt::EndSoon
) {
    Parser parser;
    bool isQuiet = false;
    parser.app.add_flag(
        "--quiet", isQuiet, "Print no line of result and no progress; notes and errors stay"
    );
    listIn(parser.app, kOutputGroup, {"--output", "--report", "--unit", "--quiet"});
    listIn(parser.app, kMendingGroup, {"--strict", "--weld", "--slits"});
    groupHelp(parser.app);
    if (printsText(parser.app, words)) {
        return ExitCode::Success;
    }
    try {
        auto arguments = parsedBy(parser, words);
        return runVerb([&](ProgressBar& bar) { return work(arguments, bar); }, after, isQuiet);
    } catch (const CLI::ParseError& error) {
        return explainParseError(parser.app, error);
    } catch (const InputError& error) {
        printError(error.what());
        return ExitCode::Usage;
    }
}

/// Takes "-" for standard input or output, which then holds this format; see isStandardStream().
inline CLI::Option* orStandardStream(CLI::Option* option, const std::string& extension) {
    return option->transform(
        [extension](const std::string& name) { return name == "-" ? name + extension : name; }, ""
    );
}

/// An option that names a file.
inline CLI::Option* addFile(
    CLI::App& app,
    const std::string& flag,
    std::filesystem::path& file,
    const std::string& help,
    const char* type = "FILE"
) {
    return app.add_option(flag, file, help)->type_name(type);
}

/// --output, which has to be given. `standard`: the format of standard output.
inline void addOutput(
    CLI::App& app,
    std::filesystem::path& file,
    const std::string& help,
    const char* type = "FILE",
    const std::string& standard = ".json"
) {
    const std::string all = help + "; -: standard output, as " + standard;
    orStandardStream(addFile(app, "--output", file, all, type), standard)->required();
}

/// --output of a mesh.
inline void addMeshOutput(
    CLI::App& app, std::filesystem::path& file, const std::string& help, const char* type = "FILE"
) {
    addOutput(app, file, help, type, ".ply");
}

/// --report.
inline void addReport(CLI::App& app, std::filesystem::path& file, const std::string& help) {
    orStandardStream(addFile(app, "--report", file, help, "FILE.json"), ".json");
}

/// MESH, and --repair, which asked for what is done by default now: accepted, not listed.
inline void addMesh(CLI::App& app, std::filesystem::path& mesh) {
    constexpr const char* kHelp =
        "Triangle mesh: .ply, .obj, .off or .stl; -: standard input, as .ply";
    orStandardStream(addFile(app, "MESH", mesh, kHelp, ""), ".ply")->required();
    constexpr const char* kHidden = "";
    app.add_flag("--repair")->group(kHidden);
}

/// --layers.
inline void addLayers(CLI::App& app, std::vector<std::string>& layers) {
    app.add_option(
           "--layers",
           layers,
           "Layers of a DXF to read, with commas between them; default: all that are not off or "
           "frozen"
    )
        ->delimiter(',')
        ->type_name("NAMES")
        ->expected(1);
}

/// Of --direction.
inline constexpr const char* kDirectionHelp =
    "Drape polylines: move each of their points along this direction to the first face that is "
    "met there, coming from outside; else they go to the nearest points";

/// --unit.
inline void addUnit(CLI::App& app, LengthUnit& unit) {
    std::vector<std::pair<std::string, LengthUnit>> words;
    for (const LengthUnit each : kLengthUnits) {
        words.emplace_back(name(each), each);
    }
    app.add_option(
           "--unit", unit, "Unit of the mesh, which .step and .iges name: mm|cm|m|um|in|ft [mm]"
    )
        ->transform(CLI::Transformer(words).description(""))  // the help names the words
        ->type_name("WORD");
}

/// --no-cache.
inline void addCacheOption(CLI::App& app, bool& noCache) {
    app.add_flag(
        "--no-cache",
        noCache,
        "Neither take a simplified shell from the cache folder nor keep it there"
    );
}

}  // namespace bspline_curve::cli
