// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verb.h"

#include "bspline_curve/error.h"
#include "cli/interrupt.h"
#include "cli/value_checks.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace bspline_curve::cli {

namespace {

/// The option that may be meant by one that is not known; empty where none is near.
std::string nearFlag(const CLI::App& app, const std::string& typed) {
    std::vector<std::string> flags;
    for (const CLI::Option* const option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            if (!option->get_group().empty()) {
                flags.push_back("--" + name);
            }
        }
    }
    return didYouMean(typed.substr(0, typed.find('=')), flags);
}

}  // namespace

void printError(const std::string& message) {
    std::string line = message;
    std::ranges::replace_if(line, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    std::cerr << "bspline_curve: " << line << '\n';
}

ExitCode reportingErrors(const std::function<ExitCode()>& run) {
    try {
        return run();
    } catch (const std::bad_alloc&) {
        printError("out of memory");
    } catch (const std::exception& error) {
        printError(std::string("internal error: ") + error.what());
    }
    return ExitCode::Failure;
}

void printNotes(std::span<const std::string> notes) {
    for (const std::string& note : notes) {
        printError("note: " + note);
    }
}

void printRemoved(std::span<const std::filesystem::path> files) {
    if (!files.empty()) {
        printError(
            "note: " + std::to_string(files.size()) + " further file" +
            (files.size() == 1 ? "" : "s") + " of an earlier run removed, the first " +
            files.front().string()
        );
    }
}

ExitCode runVerb(
    const std::function<ExitCode(ProgressBar&)>& work, AfterInterrupt after, bool isQuiet
) {
    if (after == AfterInterrupt::EndSoon) {
        endSoonAfterInterrupt();
    }
    catchInterrupts();
    ProgressBar bar(isQuiet);
    try {
        return work(bar);
    } catch (const InputError& error) {
        bar.clear();
        printError(withRemedy(error.what(), error.remedy(), kRemedyWords));
        return ExitCode::Failure;
    } catch (const Cancelled&) {
        bar.clear();
        printError(std::string(kInterruptedMessage));
        return ExitCode::Interrupted;
    }
}

Progress progressPart(ProgressBar& bar, double from, double to) {
    return [&bar, from, to](double fraction, const char* stage) {
        bar.show(from + (to - from) * fraction, stage);
        return !interrupted();
    };
}

ExitCode explainParseError(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
        static_cast<void>(app.exit(error));
        return ExitCode::Success;
    }
    // CLI11 speaks of what is missing first; what is not known tells more.
    const std::vector<std::string> unknown = app.remaining();
    const std::string reason =
        unknown.empty() ? std::string(error.what())
                        : "unknown argument " + unknown.front() + nearFlag(app, unknown.front());
    printError(reason + " (" + app.get_name() + " --help lists the options)");
    return ExitCode::Usage;
}

}  // namespace bspline_curve::cli
