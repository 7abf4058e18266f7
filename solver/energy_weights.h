// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bspline_curve {

/// Weights of (7) during one minimisation.
struct EnergyWeights {
    double alpha = 1.0;         ///< of E_dist
    double beta = 0.0;          ///< of E_fit; 0 where the picks are constraints
    double barrierWidth = 1.0;  ///< h of (11)
    /// Points outside the shell count as their nearest point of its boundary, and heights are
    /// scaled by eta (end of the paper's Sect. 4.2); for a curve that is outside already. Else it
    /// must stay inside.
    bool outsideAllowed = false;
    double avoidance = 0.0;  ///< of E_avoid
};

}  // namespace bspline_curve
