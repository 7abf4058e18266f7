// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/packet_socket.h"

#include "text/text_parsing.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

namespace bspline_curve::cli {

namespace {

/// The call again where a signal has interrupted it.
template <class Call>
ssize_t uninterrupted(Call call) {
    ssize_t result = call();
    while (result < 0 && errno == EINTR) {
        result = call();
    }
    return result;
}

}  // namespace

std::pair<int, int> makePacketSockets() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        throw std::system_error(errno, std::generic_category(), "no socket");
    }
    return {ends[0], ends[1]};
}

bool sendPacket(int socket, const std::vector<std::string>& texts) {
    std::string packet;
    for (const std::string& text : texts) {
        packet += text + '\0';
    }
    return uninterrupted([&] {
               return ::send(socket, packet.data(), packet.size(), MSG_NOSIGNAL);
           }) >= 0;
}

std::optional<std::vector<std::string>> receivePacket(int socket) {
    const ssize_t size =
        uninterrupted([&] { return ::recv(socket, nullptr, 0, MSG_PEEK | MSG_TRUNC); });
    if (size <= 0) {
        return std::nullopt;
    }
    std::string packet(static_cast<std::size_t>(size), '\0');
    if (uninterrupted([&] { return ::recv(socket, packet.data(), packet.size(), 0); }) != size) {
        return std::nullopt;
    }
    packet.pop_back();
    std::vector<std::string> texts;
    for (const std::string_view text : splitAt(packet, '\0')) {
        texts.emplace_back(text);
    }
    return texts;
}

}  // namespace bspline_curve::cli
