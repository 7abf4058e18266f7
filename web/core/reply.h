// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::web {

using Json = nlohmann::json;

/// What a call answers: JSON in which arrays stand as {"$f64": [address, count]} (also $i32, $u8).
/// They live until the next call, so that the page can copy them.
class Reply {
public:
    [[nodiscard]] Json array(std::vector<double> values);
    [[nodiscard]] Json array(std::vector<int> values);
    [[nodiscard]] Json array(std::vector<Vec3> values);
    [[nodiscard]] Json array(std::vector<Triangle> values);
    [[nodiscard]] Json array(std::vector<std::uint8_t> values);
    /// The bytes of a file.
    [[nodiscard]] Json bytes(std::string values);

    /// Arrays of something that is kept as long; nothing is copied here.
    template <class Owner, class Value>
    [[nodiscard]] Json view(std::shared_ptr<const Owner> owner, const std::vector<Value>& values) {
        owners_.push_back(std::move(owner));
        return described(values);
    }

private:
    template <class Container>
    Json kept(Container values) {
        auto owner = std::make_shared<const Container>(std::move(values));
        const Container& place = *owner;
        owners_.push_back(std::move(owner));
        return described(place);
    }

    static Json described(const std::vector<double>& values);
    static Json described(const std::vector<int>& values);
    static Json described(const std::vector<Vec3>& values);
    static Json described(const std::vector<Triangle>& values);
    static Json described(const std::vector<std::uint8_t>& values);
    static Json described(const std::string& values);

    std::vector<std::shared_ptr<const void>> owners_;
};

// What a call is given; arrays stand as above. Each throws nlohmann's exceptions where the page's
// own code is wrong.

[[nodiscard]] std::string_view bytesOf(const Json& array);
[[nodiscard]] std::span<const double> numbersOf(const Json& array);
[[nodiscard]] std::span<const int> idsOf(const Json& array);
/// Of three numbers each.
[[nodiscard]] std::vector<Vec3> pointsOf(const Json& array);
[[nodiscard]] Vec3 pointOf(const Json& coordinates);

}  // namespace bspline_curve::web
