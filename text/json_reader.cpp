// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/json_reader.h"

#include "text/text_parsing.h"

#include <string>

namespace bspline_curve {

namespace {

using nlohmann::json;

constexpr int kDeepestNesting = 64;

}  // namespace

json jsonOfBytes(const std::filesystem::path& file, std::string_view bytes) {
    const auto refuseDeepNesting = [&](int depth, json::parse_event_t event, const json&) {
        const bool opens =
            event == json::parse_event_t::array_start || event == json::parse_event_t::object_start;
        if (opens && depth >= kDeepestNesting) {
            refuseFile(
                file,
                "nests arrays or objects more than " + std::to_string(kDeepestNesting) + " deep"
            );
        }
        return true;
    };
    try {
        return json::parse(bytes, refuseDeepNesting);
    } catch (const json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 2: …"
        const std::string text = error.what();
        const std::size_t end = text.find("] ");
        refuseFile(
            file, "is not JSON: " + (end == std::string::npos ? text : text.substr(end + 2))
        );
    }
}

}  // namespace bspline_curve
