// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/drawn_curve.h"  // IWYU pragma: export
