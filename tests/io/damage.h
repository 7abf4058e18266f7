// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

namespace bspline_curve::io_tests {

/// Some bytes changed, lost or added; new ones are of `alphabet`, a line end, a zero or 0xff.
inline std::string damaged(std::string bytes, std::string alphabet, std::mt19937& random) {
    alphabet.append("\n\xff").append(1, '\0');
    for (unsigned k = 0; k <= random() % 3 && !bytes.empty(); ++k) {
        const std::size_t at = random() % bytes.size();
        switch (random() % 3) {
            case 0:
                bytes[at] = alphabet[random() % alphabet.size()];
                break;
            case 1:
                bytes.erase(at, 1 + random() % 4);
                break;
            default:
                bytes.insert(at, 1, alphabet[random() % alphabet.size()]);
                break;
        }
    }
    return bytes;
}

}  // namespace bspline_curve::io_tests
