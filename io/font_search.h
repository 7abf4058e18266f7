// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

// The font of a text for which none was given.
namespace bspline_curve {

/// Where fonts of this system may be, those of all users first. Linux: what XDG_DATA_DIRS,
/// XDG_DATA_HOME and HOME name; macOS: the folders of the system and of HOME; Windows: those of
/// SystemRoot and LOCALAPPDATA. Folders need not exist.
[[nodiscard]] std::vector<std::filesystem::path> fontFolders();

/// The file of the first well-known upright sans serif that these folders hold, at any depth:
/// DejaVu Sans, Liberation Sans, Noto Sans, Arial, Helvetica, and a few more. Of several files of
/// one font that of the first folder, there the first by its path. Upper and lower case of names
/// are one. Returns nullopt where there is none. Folders that cannot be read are passed over.
[[nodiscard]] std::optional<std::filesystem::path> findFont(
    std::span<const std::filesystem::path> folders
);

}  // namespace bspline_curve
