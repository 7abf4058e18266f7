// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "filters/parameter_values.h"
#include "web/core/objects.h"
#include "web/core/reply.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The calls of the module, by name: "mesh.load". What each takes and answers stands with it.
namespace bspline_curve::web {

using Call = Json (*)(const Json& arguments, Reply& reply);
using Calls = std::map<std::string_view, Call>;

[[nodiscard]] const Calls& meshCalls();
[[nodiscard]] const Calls& curveCalls();
[[nodiscard]] const Calls& useCalls();
[[nodiscard]] const Calls& sessionCalls();

/// Tells the page how far a call is.
[[nodiscard]] Progress hostProgress();

/// The error that is being handled, as the page gets it: {"code", "message", "elements"}.
[[nodiscard]] Json currentError();

// ---- Shared by calls

/// The values of a filter's parameters that a JSON object names, as in docs/PARAMETERS.md; null:
/// all defaults. Throws InputError (BadOption) where there is no such parameter, or where a value
/// is of another type.
[[nodiscard]] ParameterValues valuesOfJson(const FilterDescription& filter, const Json& options);

/// What a page needs to show a mesh: {"mesh": number, "vertices", "faces", "colours" (0 to 255, 3
/// of each vertex; null where there are none), "diagonal", "components", "mending", "notes"}.
[[nodiscard]] Json meshJson(std::shared_ptr<const Mesh> mesh, Reply& reply);
/// The polyline and the spline, named as in Python, and what the report says of them.
[[nodiscard]] Json curveJson(std::shared_ptr<const DrawnOnMesh> curve, Reply& reply);
/// A mesh that was made of another by an imprint.
[[nodiscard]] std::shared_ptr<const Mesh> madeMesh(const Mesh& of, const MadeMesh& made);
[[nodiscard]] std::vector<std::shared_ptr<const DrawnOnMesh>> curvesOf(const Json& numbers);

/// A message, and what helps in words of pages.
[[nodiscard]] std::string messageOf(const std::string& message, const Remedy& remedy);

}  // namespace bspline_curve::web
