// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "host_document.h"

namespace bspline_curve {

/// From now on, whenever the host's window saves a layer of a curve into a file, what that file
/// cannot hold goes into another one beside it, see writeSideFile(), and a line of the document's
/// log tells so. For layers of other polylines a line tells where a format keeps no edges. Once
/// for each document, also where several plugins ask; in its window's thread, until it ends.
void watchSaving(MeshDocument& document);

}  // namespace bspline_curve
