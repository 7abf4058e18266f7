// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"
#include "cli/manual.h"
#include "cli/process_figures.h"
#include "cli/value_checks.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct Verb {
    std::string_view name;
    ExitCode (*run)(Arguments);
    const char* help;
};

// A first argument that is none of these is a mesh, or an option of `curve`.
constexpr std::array kVerbs{
    Verb{
        .name = "curve",
        .run = runCurve,
        .help = "a smooth curve through picks on a mesh; may be left out"
    },
    Verb{
        .name = "fit",
        .run = runFit,
        .help = "smooth curves along lines that exist: boundaries, strokes, polylines"
    },
    Verb{.name = "batch", .run = runBatch, .help = "many curves, as a table lists them"},
    Verb{.name = "imprint", .run = runImprint, .help = "curves as edges of the mesh"},
    Verb{
        .name = "cut",
        .run = runCut,
        .help = "the mesh opened along curves, parts of it, holes filled, reliefs"
    },
    Verb{.name = "fill", .run = runFill, .help = "holes that a mesh has closed, flat or smooth"},
    Verb{
        .name = "segment",
        .run = runSegment,
        .help = "labels, colours and measures of the parts between curves"
    },
    Verb{
        .name = "offset",
        .run = runOffset,
        .help = "curves at a distance from a curve, along the surface"
    },
    Verb{
        .name = "pattern",
        .run = runPattern,
        .help = "a planar drawing carried to the surface as curves"
    },
    Verb{
        .name = "edit", .run = runEdit, .help = "curves turned round, cut, joined and made longer"
    },
    Verb{
        .name = "points",
        .run = runPoints,
        .help = "points along curves, with frames and curvatures"
    },
    Verb{
        .name = "field",
        .run = runField,
        .help = "values at vertices that curves can follow or avoid"
    },
    Verb{
        .name = "shell",
        .run = runShell,
        .help = "the shell of a mesh, to look at, check and use elsewhere"
    }
};

ExitCode printOverview() {
    std::cout << "Smooth B-spline curves on triangle meshes, and what is made of them.\n"
                 "Usage: bspline_curve [VERB] MESH OPTIONS...\n\nVerbs:\n";
    constexpr std::size_t kColumn = 10;
    for (const Verb& verb : kVerbs) {
        std::cout << "  " << verb.name << std::string(kColumn - verb.name.size(), ' ') << verb.help
                  << '\n';
    }
    std::cout << "\n"
                 "  VERB --help: its options; --help paper; --version; --completion bash|zsh|fish\n"
                 "Examples:\n"
                 "  bspline_curve scan.ply --picks picks.json --closed --output curve.json\n"
                 "  bspline_curve cut scan.ply --curve curve.json --keep inside --output cut.ply\n"
                 "Exit status: 0 done; 1 bad mesh, picks or file; 2 wrong usage; 130 interrupted\n"
                 "by Ctrl-C. No output is written unless the status is 0.\n";
    return ExitCode::Success;
}

std::vector<VerbSummary> summaries() {
    std::vector<VerbSummary> all;
    for (const Verb& verb : kVerbs) {
        all.emplace_back(verb.name, verb.help);
    }
    return all;
}

/// --completion SHELL
ExitCode printCompletionFor(const std::string& shell) {
    const std::array words{kCompletion, shell.c_str()};
    const auto printVerb = [&](std::string_view name) {
        static_cast<void>(std::ranges::find(kVerbs, name, &Verb::name)->run(words));
    };
    if (printCompletion(shell, summaries(), printVerb)) {
        return ExitCode::Success;
    }
    printError("--completion is for bash, zsh or fish");
    return ExitCode::Usage;
}

/// What is asked of the program as a whole; else nothing.
std::optional<ExitCode> runWithoutVerb(Arguments arguments) {
    const std::string word = arguments.front();
    const bool isAlone = arguments.size() == 1;
    if (word == kMeshProcess) {
        return runMeshProcess();
    }
    if (isAlone && (word == "help" || word == "--help" || word == "-h")) {
        return printOverview();
    }
    if (isAlone && word == kManual) {
        std::cout << programManual(summaries());
        return ExitCode::Success;
    }
    if (word == kCompletion) {
        return printCompletionFor(isAlone ? "" : arguments[1]);
    }
    return std::nullopt;
}

ExitCode refuseVerb(const std::string& word) {
    std::vector<std::string> words{"help"};
    for (const Verb& verb : kVerbs) {
        words.emplace_back(verb.name);
    }
    printError(
        word + " is neither a mesh file nor one of the verbs " + joined(words) +
        didYouMean(word, words)
    );
    return ExitCode::Usage;
}

/// Whether a word can name no mesh: there is no such file, and meshes have extensions.
bool isNoMesh(const std::string& word) {
    return !word.starts_with('-') && std::filesystem::path(word).extension().empty() &&
           !std::filesystem::exists(word);
}

ExitCode run(Arguments arguments) {
    if (arguments.empty()) {
        return runCurve(arguments);
    }
    if (const std::optional<ExitCode> done = runWithoutVerb(arguments)) {
        return *done;
    }
    const std::string word = arguments.front();
    if (word == "help") {
        // `help VERB paper` is `VERB --help paper`, and `help paper` is `--help paper`.
        std::vector<const char*> words(arguments.begin() + 1, arguments.end());
        words.insert(
            words.begin() + (std::string_view(words.front()) == "paper" ? 0 : 1), "--help"
        );
        return run(words);
    }
    const auto* const verb = std::ranges::find(kVerbs, word, &Verb::name);
    if (verb != kVerbs.end()) {
        const Arguments rest = arguments.subspan(1);
        if (rest.size() == 1 && std::string_view(rest.front()) == kManual) {
            return verb->run(std::array{kManual, verb->help});
        }
        return verb->run(rest);
    }
    return isNoMesh(word) ? refuseVerb(word) : runCurve(arguments);
}

}  // namespace

}  // namespace bspline_curve::cli

int main(int argc, char** argv) {
    using namespace bspline_curve::cli;
    returnLargeArrays();
#ifdef SIGXFSZ
    static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));  // a file that grows too large is an error
#endif
    const Arguments all(argv, argc);
    return static_cast<int>(reportingErrors([&] {
        return run(all.subspan(std::min<std::size_t>(all.size(), 1)));
    }));
}
