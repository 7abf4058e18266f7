// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.h"

#include "bspline_curve/progress.h"

#include <csignal>

namespace bspline_curve::cli {

namespace {

// The one thing that a signal handler may write to.
volatile std::sig_atomic_t interruptSeen = 0;

extern "C" void onInterrupt(int signal) {
    interruptSeen = 1;
    static_cast<void>(std::signal(signal, SIG_DFL));
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

}  // namespace bspline_curve::cli
