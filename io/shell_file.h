// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_builder.h"
#include "surface/surface.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace bspline_curve {

// A simplified shell as a file: what took long to compute, and enough to notice that it belongs to
// something else. The extended surface is not in it, since it follows from the surface; its
// checksum is.
//
// Little endian throughout; counts and indices are 32 bits wide, reals are IEEE doubles.
//   8 bytes   "BSCSHELL"
//   u32       version, 1
//   u64       bytes of the whole file
//   u64, u64  checksums of surface and base
//   u32, …    parameters: length and bytes
//   u32 × 5   pillars, prisms, track entries, blocked faces, intersecting pairs
//   i32, i32  rounds of the builder (orientation, intersection)
//   f64 × 9   of each pillar: bottom, middle, top, in the frame of the extended surface
//   i32 × 6, i8 × 7  of each prism: pillars, neighbours; faceCorner, neighbourWalls, orientation
//   i32, …    track offsets (prisms + 1), track entries, blocked faces, intersecting pairs
//   u64       checksum of all bytes before
// Checksums are 64-bit FNV-1a: it is one-to-one in each byte, so no single changed byte escapes.

/// Checksum of what a shell depends on: vertices, bit by bit, and faces. 1 ms per MB.
[[nodiscard]] std::uint64_t surfaceChecksum(const Surface& surface);

/// Writes a simplified shell and its report; `parameters` says, in words of the caller's, what it
/// was built with. Appears whole or not at all. Throws InputError (UnwritableFile).
void saveShell(
    const std::filesystem::path& file,
    const Surface& surface,
    const ExtendedSurface& extended,
    std::string_view parameters,
    const ShellBuild& build
);

/// Reads a shell that was saved for the same surface, base and parameters. Every index is valid;
/// the invariants are not checked (see checkShell). Throws InputError (UnreadableFile) that names
/// the file and what does not match or is damaged.
[[nodiscard]] ShellBuild loadShell(
    const std::filesystem::path& file,
    const Surface& surface,
    const std::shared_ptr<const ExtendedSurface>& extended,
    std::string_view parameters
);

/// The same from the bytes of a file that is read already.
[[nodiscard]] ShellBuild decodeShell(
    const std::filesystem::path& file,
    std::string_view bytes,
    const Surface& surface,
    const std::shared_ptr<const ExtendedSurface>& extended,
    std::string_view parameters
);

}  // namespace bspline_curve
