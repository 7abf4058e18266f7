// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/curve_options.h"
#include "bspline_curve/error.h"
#include "text/error_messages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <system_error>

namespace bspline_curve {

namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kBetweenNumbers = ", \t";
constexpr std::string_view kAny = "any";

class DirectionsParser {
public:
    DirectionsParser(const std::string& text, const std::string& name)
        : text_(text), name_(name), rest_(text) {}

    [[nodiscard]] PickDirections parse() {
        PickDirections directions;
        for (skip(kBlanks); !rest_.empty(); skip(kBlanks)) {
            const int pick = number<int>();
            skip(kBlanks);
            take(':');
            PickTangent tangent = PickTangent::along(direction());
            if (has('/')) {
                take('/');
                tangent.after = direction();
            }
            if (pick < 1 || tangent.isAny()) {
                refuse();
            }
            directions.entries.emplace_back(pick - 1, tangent);
            if (!rest_.empty()) {
                take(';');
            }
        }
        return directions;
    }

private:
    [[noreturn]] void refuse() const {
        throw InputError(
            InputErrorCode::BadOption,
            name_ + " is \"" + text_ +
                R"(", but must be a pick's number, from 1, and a direction that is not zero, as "1: 1, 0, 0; 4: 0, 1, 0"; of a corner two, as "2: 1, 0, 0 / 0, 1, 0")"
        );
    }

    /// Zero: any.
    Vec3 direction() {
        skip(kBlanks);
        Vec3 direction = Vec3::Zero();
        if (rest_.starts_with(kAny)) {
            rest_.remove_prefix(kAny.size());
        } else {
            for (double& coordinate : direction) {
                skip(kBetweenNumbers);
                coordinate = number<double>();
            }
            if (!direction.allFinite() || direction.isZero(0.0)) {
                refuse();
            }
        }
        skip(kBlanks);
        return direction;
    }

    [[nodiscard]] bool has(char letter) const { return rest_.starts_with(letter); }

    void skip(std::string_view letters) {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(letters), rest_.size()));
    }

    void take(char letter) {
        if (!has(letter)) {
            refuse();
        }
        rest_.remove_prefix(1);
    }

    template <class Number>
    Number number() {
        Number value{};
        const auto [stop, error] =
            std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc()) {
            refuse();
        }
        rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
        return value;
    }

    const std::string& text_;
    const std::string& name_;
    std::string_view rest_;
};

std::string shortest(double value) {
    constexpr std::size_t kMostLetters = 32;
    std::array<char, kMostLetters> letters{};
    const auto [end, error] = std::to_chars(letters.data(), letters.data() + letters.size(), value);
    return {letters.data(), end};
}

std::string describe(const Vec3& direction) {
    if (direction.isZero(0.0)) {
        return std::string(kAny);
    }
    return shortest(direction.x()) + "," + shortest(direction.y()) + "," + shortest(direction.z());
}

}  // namespace

std::vector<PickTangent> PickDirections::of(std::size_t count) const {
    if (entries.empty()) {
        return {};
    }
    std::vector<PickTangent> directions(count);
    for (const auto& [pick, direction] : entries) {
        if (pick < 0 || pick >= static_cast<int>(count)) {
            throw InputError(
                InputErrorCode::BadOption,
                describePicks({pick}) + " has a tangent, but there are " +
                    describeCount(count, "pick", "picks"),
                {pick}
            );
        }
        directions[pick] = direction;
    }
    return directions;
}

PickDirections parsePickDirections(const std::string& text, const std::string& name) {
    return DirectionsParser(text, name).parse();
}

std::string describe(const PickDirections& directions) {
    std::string text;
    for (const auto& [pick, tangent] : directions.entries) {
        text.append(text.empty() ? "" : ";").append(std::to_string(pick + 1)).append(":");
        text.append(describe(tangent.before));
        if (!tangent.isOne()) {
            text.append("/").append(describe(tangent.after));
        }
    }
    return text;
}

}  // namespace bspline_curve
