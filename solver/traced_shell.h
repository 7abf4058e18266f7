// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/near_shell.h"
#include "solver/curve_problem.h"

#include <vector>

namespace bspline_curve {

/// A shell to trace a curve through, and the point of the surface near which the curve starts.
/// Refers to what it is made from.
struct TracedShell {
    const Shell& shell;
    const ShellBase& base;
    SurfacePoint start;
    Vec3 startPosition;
    /// What each face of the base is called in the surface, where the base is a part of it; null:
    /// as in the base.
    const std::vector<int>* faceNames = nullptr;

    [[nodiscard]] int nameOf(int face) const {
        return faceNames == nullptr ? face : (*faceNames)[static_cast<std::size_t>(face)];
    }
};

/// The shell of a problem, which it must have.
[[nodiscard]] inline TracedShell tracedShellOf(const CurveProblem& problem) {
    const PickConstraint& first = problem.picks.front();
    return {*problem.shell, *problem.base, first.point, first.position};
}

/// A shell that holds the first pick.
[[nodiscard]] inline TracedShell tracedShellOf(const NearShell& near, const PickConstraint& first) {
    return {near.shell, near.base, near.here(first.point), first.position, &near.faces};
}

/// `near`, or the shell of the problem where that is null.
[[nodiscard]] inline TracedShell tracedShellOf(const CurveProblem& problem, const NearShell* near) {
    return near == nullptr ? tracedShellOf(problem) : tracedShellOf(*near, problem.picks.front());
}

}  // namespace bspline_curve
