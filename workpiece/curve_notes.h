// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/report.h"

#include <string>
#include <vector>

namespace bspline_curve {

/// Why a curve is not usable, for people: how it was made, how far it is from the surface, on which
/// parameters and faces that is, as far as it is known, and what to do. One line without a stop.
[[nodiscard]] std::string describeUnusable(const SolveReport& report);

/// By how much the field was weakened, for people; empty where it was not.
[[nodiscard]] std::string describeWeakenedField(const SolveReport& report);

/// Which picks are at the same point as the one before, for people; empty where none is.
[[nodiscard]] std::string describeRepeatedPicks(const SolveReport& report);

/// Where the curve goes farther than it had to, for people; empty where it does not.
[[nodiscard]] std::string describeDetours(const SolveReport& report);

/// What people must know of a curve that was drawn, in the order in which hosts say it: of repeated
/// picks, of the field, and why it is not usable.
[[nodiscard]] std::vector<std::string> notesOf(const SolveReport& report);

}  // namespace bspline_curve
