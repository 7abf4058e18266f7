// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"
#include "cli/process_figures.h"
#include "cli/value_checks.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct Verb {
    std::string_view name;
    ExitCode (*run)(Arguments);
};

// A first argument that is none of these is a mesh, or an option of `curve`.
constexpr std::array kVerbs{
    Verb{.name = "batch", .run = runBatch},
    Verb{.name = "curve", .run = runCurve},
    Verb{.name = "cut", .run = runCut},
    Verb{.name = "field", .run = runField},
    Verb{.name = "fit", .run = runFit},
    Verb{.name = "imprint", .run = runImprint},
    Verb{.name = "offset", .run = runOffset},
    Verb{.name = "pattern", .run = runPattern},
    Verb{.name = "points", .run = runPoints},
    Verb{.name = "segment", .run = runSegment},
    Verb{.name = "shell", .run = runShell}
};

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
    const std::string word = arguments.front();
    if (word == kMeshProcess) {
        return runMeshProcess();
    }
    if (word == "help") {
        std::vector<const char*> words(arguments.begin() + 1, arguments.end());
        words.push_back("--help");
        return run(words);
    }
    const auto* const verb = std::ranges::find(kVerbs, word, &Verb::name);
    if (verb != kVerbs.end()) {
        return verb->run(arguments.subspan(1));
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
