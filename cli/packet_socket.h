// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

// Messages between processes: lists of texts without zero bytes, over a socket that keeps them
// apart.
namespace bspline_curve::cli {

/// Two ends of a new socket, which programs that are started do not inherit. Throws
/// std::system_error.
[[nodiscard]] std::pair<int, int> makePacketSockets();

/// False where nobody is there to receive it, or it is too large.
[[nodiscard]] bool sendPacket(int socket, const std::vector<std::string>& texts);

/// Waits for the next message; nullopt at the end.
[[nodiscard]] std::optional<std::vector<std::string>> receivePacket(int socket);

}  // namespace bspline_curve::cli
