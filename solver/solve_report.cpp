// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/report.h"

namespace bspline_curve {

const char* name(Detour::Round round) {
    switch (round) {
        case Detour::Round::Slit:
            return "slit";
        case Detour::Round::Cut:
            return "cut";
        case Detour::Round::Guides:
            break;
    }
    return "guides";
}

const char* name(SolveStatus status) {
    switch (status) {
        case SolveStatus::Converged:
            return "converged";
        case SolveStatus::DistanceReached:
            return "distance reached";
        case SolveStatus::KnotLimit:
            return "knot limit";
        case SolveStatus::RoundLimit:
            return "round limit";
        case SolveStatus::TightFit:
            return "tight fit";
        case SolveStatus::ShortestPath:
            return "shortest path";
    }
    return "unknown";
}

const char* name(MinimiseStatus status) {
    switch (status) {
        case MinimiseStatus::Converged:
            return "converged";
        case MinimiseStatus::LineSearchStalled:
            return "line search stalled";
        case MinimiseStatus::IterationLimit:
            return "iteration limit";
        case MinimiseStatus::NotPositive:
            return "not positive definite";
        case MinimiseStatus::Outside:
            return "outside the shell";
    }
    return "unknown";
}

}  // namespace bspline_curve
