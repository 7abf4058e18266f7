// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/child_process.h"

#include "cli/process_figures.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <system_error>

namespace bspline_curve::cli {

namespace {

constexpr const char* kThisProgram = "/proc/self/exe";
constexpr const char* kNothing = "/dev/null";
constexpr std::size_t kMostPrinted = 1 << 16;

[[noreturn]] void refuseErrno(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

constexpr int kNotStarted = 127;

/// Replaces a child's standard streams; false where that fails. `input`: -1 for nothing.
bool redirectStreams(int input, int standardError) {
    const int nothing = ::open(kNothing, O_RDWR);
    return nothing >= 0 && ::dup2(input < 0 ? nothing : input, STDIN_FILENO) >= 0 &&
           ::dup2(nothing, STDOUT_FILENO) >= 0 && ::dup2(standardError, STDERR_FILENO) >= 0;
}

bool limitMemory(const std::optional<std::uint64_t>& bytes) {
    if (!bytes) {
        return true;
    }
    const rlimit limit{.rlim_cur = *bytes, .rlim_max = *bytes};
    return ::setrlimit(RLIMIT_AS, &limit) == 0;
}

/// A child's first steps: only calls that are safe after fork.
void leaveParent(pid_t parent) {
    static_cast<void>(::setpgid(0, 0));
#ifdef __linux__
    static_cast<void>(::prctl(PR_SET_PDEATHSIG, SIGINT));
    if (::getppid() != parent) {
        ::_exit(kNotStarted);  // it ended before the line above
    }
#endif
}

}  // namespace

template <class Become>
void ChildProcess::start(Become become) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        refuseErrno("no pipe");
    }
    const pid_t parent = ::getpid();
    id_ = ::fork();
    if (id_ == 0) {
        leaveParent(parent);
        become(ends[1]);
    }
    const int reason = errno;
    ::close(ends[1]);
    pipe_ = ends[0];
    if (id_ < 0) {
        ::close(pipe_);
        errno = reason;
        refuseErrno("no process");
    }
}

ChildProcess::ChildProcess(const Request& request) {
    // Between fork and exec nothing may be allocated.
    std::vector<std::string> texts{"bspline_curve"};
    texts.insert(texts.end(), request.arguments.begin(), request.arguments.end());
    std::vector<char*> words;
    for (std::string& text : texts) {
        words.push_back(text.data());
    }
    words.push_back(nullptr);
    start([&](int standardError) {
        if (redirectStreams(request.standardInput, standardError) &&
            ::chdir(request.directory.c_str()) == 0 && limitMemory(request.memoryBytes)) {
            ::execv(kThisProgram, words.data());
        }
        const char* const reason = std::strerror(errno);
        static_cast<void>(::write(STDERR_FILENO, reason, std::strlen(reason)) < 0);
        ::_exit(kNotStarted);
    });
}

ChildProcess::ChildProcess(const std::function<ExitCode()>& work) {
    start([&](int standardError) {
        constexpr int kNoInput = -1;
        if (!redirectStreams(kNoInput, standardError)) {
            ::_exit(kNotStarted);
        }
        const ExitCode code = work();
        std::cerr.flush();
        // What belongs to the parent, such as temporary files, is left alone.
        ::_exit(static_cast<int>(code));
    });
}

ChildProcess::~ChildProcess() {
    ::close(pipe_);
    if (id_ > 0) {
        interrupt();
        static_cast<void>(::waitpid(id_, nullptr, 0));
    }
}

bool ChildProcess::read() {
    std::array<char, 4096> block{};
    const ssize_t count = ::read(pipe_, block.data(), block.size());
    if (count < 0) {
        return errno == EINTR || errno == EAGAIN;
    }
    const std::size_t room = kMostPrinted - std::min(printed_.size(), kMostPrinted);
    printed_.append(block.data(), std::min(static_cast<std::size_t>(count), room));
    return count > 0;
}

void ChildProcess::interrupt() const {
    static_cast<void>(::kill(id_, SIGINT));
}

ChildProcess::End ChildProcess::wait() {
    int status = 0;
    rusage usage{};
    while (::wait4(id_, &status, 0, &usage) < 0) {
        if (errno != EINTR) {
            refuseErrno("no end of a process");
        }
    }
    id_ = -1;
    return {
        .exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 0,
        .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0,
        .peakMemoryBytes = static_cast<std::int64_t>(usage.ru_maxrss) * kKilobyte
    };
}

}  // namespace bspline_curve::cli
