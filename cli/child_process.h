// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve::cli {

/// A process beside this one, with nothing to read from its standard input and output. It ends by
/// itself where this one ends; Ctrl-C in a terminal does not reach it.
class ChildProcess {
public:
    /// This program, run once more.
    struct Request {
        std::vector<std::string> arguments;        ///< after the program's name
        std::filesystem::path directory;           ///< to run in
        std::optional<std::uint64_t> memoryBytes;  ///< address space at most
        int standardInput = -1;                    ///< a descriptor; -1: nothing
    };

    /// How it ended.
    struct End {
        int exitCode = 0;
        int signal = 0;  ///< that ended it; 0: none
        std::int64_t peakMemoryBytes = 0;
    };

    /// Throws std::system_error where the system starts no more processes.
    explicit ChildProcess(const Request& request);
    /// A copy of this process as it is, for `work`, whose result it ends with; for processes of one
    /// thread. Throws std::system_error.
    explicit ChildProcess(const std::function<ExitCode()>& work);
    ~ChildProcess();  ///< interrupts it where wait() was not called, and waits
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Where its stderr can be read; readable also at its end.
    [[nodiscard]] int descriptor() const { return pipe_; }

    /// Takes what there is of its stderr; false at the end.
    [[nodiscard]] bool read();

    /// What it printed to stderr so far; only the beginning where that is very long.
    [[nodiscard]] const std::string& printed() const { return printed_; }

    /// As Ctrl-C.
    void interrupt() const;

    /// Once, after read() said false.
    [[nodiscard]] End wait();

private:
    /// `become`: what the child does with the descriptor of its stderr.
    template <class Become>
    void start(Become become);

    pid_t id_ = -1;
    int pipe_ = -1;
    std::string printed_;
};

}  // namespace bspline_curve::cli
