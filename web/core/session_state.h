// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "web/core/objects.h"
#include "web/core/reply.h"

namespace bspline_curve::web {

/// What a page shows of a session. Of a curve that is as the page was told before, only its `id`;
/// else {"id", "name", "colour", "hidden", "options", "picks", "kinds" (numbers of PickKind),
/// "tangents", "tangents_before", "normals" and "leeway" of picks, "points", "problem", "settled",
/// "usable", "length", "notes"}. Besides "curves": "active", "selected", "hovered", "stroke",
/// "dragging", "can_undo", "can_redo", "snapped", "preview", "is_settled".
[[nodiscard]] Json stateJson(Session& session, Reply& reply);

/// The options that drawing tools offer, named as in docs/PARAMETERS.md.
[[nodiscard]] Json optionsJson(const DrawnOptions& options);

}  // namespace bspline_curve::web
