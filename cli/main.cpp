// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"
#include "cli/process_figures.h"

#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>

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
    Verb{.name = "field", .run = runField},
    Verb{.name = "shell", .run = runShell}
};

ExitCode run(Arguments arguments) {
    const auto isNamed = [&](const Verb& verb) {
        return !arguments.empty() && verb.name == arguments.front();
    };
    const auto* const verb = std::ranges::find_if(kVerbs, isNamed);
    return verb == kVerbs.end() ? runCurve(arguments) : verb->run(arguments.subspan(1));
}

}  // namespace

void printError(const std::string& message) {
    std::string line = message;
    std::ranges::replace_if(line, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    std::cerr << "bspline_curve: " << line << '\n';
}

}  // namespace bspline_curve::cli

int main(int argc, char** argv) {
    using namespace bspline_curve::cli;
    returnLargeArrays();
    try {
        const Arguments all(argv, argc);
        return static_cast<int>(run(all.subspan(std::min<std::size_t>(all.size(), 1))));
    } catch (const std::bad_alloc&) {
        printError("out of memory");
    } catch (const std::exception& error) {
        printError(std::string("internal error: ") + error.what());
    }
    return static_cast<int>(ExitCode::Failure);
}
