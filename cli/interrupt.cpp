// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.h"

#include "bspline_curve/atomic_file.h"
#include "bspline_curve/progress.h"
#include "cli/command.h"

#include <semaphore.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <mutex>
#include <string>
#include <thread>

namespace bspline_curve::cli {

namespace {

constexpr std::chrono::milliseconds kPatience{100};  // half of what is promised

// What a signal handler may write to.
volatile std::sig_atomic_t interruptSeen = 0;
sem_t interruptCame;  // once watched
volatile std::sig_atomic_t isWatched = 0;

// Held by who ends the process or goes on to write.
std::mutex endMutex;
bool isWriting = false;

extern "C" void onInterrupt(int signal) {
    interruptSeen = 1;
    static_cast<void>(std::signal(signal, SIG_DFL));
    if (isWatched != 0) {
        const int error = errno;
        static_cast<void>(::sem_post(&interruptCame));
        errno = error;
    }
}

void endAfterInterrupt() {
    while (::sem_wait(&interruptCame) != 0) {  // EINTR
    }
    std::this_thread::sleep_for(kPatience);
    const std::scoped_lock lock(endMutex);
    if (isWriting) {
        return;
    }
    AtomicFile::abandonAll();
    const std::string clear = ::isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : "";  // the progress bar
    const std::string line = clear + "bspline_curve: " + std::string(kInterruptedMessage) + "\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
    ::_exit(static_cast<int>(ExitCode::Interrupted));
}

}  // namespace

void catchInterrupts() {
    static_cast<void>(std::signal(SIGINT, onInterrupt));
}

bool interrupted() {
    return interruptSeen != 0;
}

void throwIfInterrupted() {
    if (interrupted()) {
        throw Cancelled();
    }
}

void endSoonAfterInterrupt() {
    static_cast<void>(::sem_init(&interruptCame, 0, 0));
    std::thread(endAfterInterrupt).detach();
    isWatched = 1;
}

void beginWriting() {
    const std::scoped_lock lock(endMutex);
    throwIfInterrupted();
    isWriting = true;
}

}  // namespace bspline_curve::cli
