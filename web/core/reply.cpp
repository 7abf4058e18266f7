// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/reply.h"

namespace bspline_curve::web {

namespace {

Json describedArray(const char* type, const void* data, std::size_t count) {
    return {{type, {reinterpret_cast<std::uintptr_t>(data), count}}};
}

template <class Value>
std::span<const Value> spanAt(const Json& array, const char* type) {
    const Json& place = array.at(type);
    const auto address = place.at(0).get<std::uintptr_t>();
    // NOLINTNEXTLINE(performance-no-int-to-ptr): pages know addresses as numbers
    return {reinterpret_cast<const Value*>(address), place.at(1).get<std::size_t>()};
}

}  // namespace

// Vectors of three are three numbers one after the other.
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(int));

Json Reply::described(const std::vector<double>& values) {
    return describedArray("$f64", values.data(), values.size());
}

Json Reply::described(const std::vector<int>& values) {
    return describedArray("$i32", values.data(), values.size());
}

Json Reply::described(const std::vector<Vec3>& values) {
    return describedArray("$f64", values.data(), 3 * values.size());
}

Json Reply::described(const std::vector<Triangle>& values) {
    return describedArray("$i32", values.data(), 3 * values.size());
}

Json Reply::described(const std::vector<std::uint8_t>& values) {
    return describedArray("$u8", values.data(), values.size());
}

Json Reply::described(const std::string& values) {
    return describedArray("$u8", values.data(), values.size());
}

Json Reply::array(std::vector<double> values) {
    return kept(std::move(values));
}

Json Reply::array(std::vector<int> values) {
    return kept(std::move(values));
}

Json Reply::array(std::vector<Vec3> values) {
    return kept(std::move(values));
}

Json Reply::array(std::vector<Triangle> values) {
    return kept(std::move(values));
}

Json Reply::array(std::vector<std::uint8_t> values) {
    return kept(std::move(values));
}

Json Reply::bytes(std::string values) {
    return kept(std::move(values));
}

std::string_view bytesOf(const Json& array) {
    const std::span<const char> bytes = spanAt<char>(array, "$u8");
    return {bytes.data(), bytes.size()};
}

std::span<const double> numbersOf(const Json& array) {
    return spanAt<double>(array, "$f64");
}

std::span<const int> idsOf(const Json& array) {
    return spanAt<int>(array, "$i32");
}

std::vector<Vec3> pointsOf(const Json& array) {
    const std::span<const double> numbers = numbersOf(array);
    std::vector<Vec3> points;
    points.reserve(numbers.size() / 3);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
        points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    return points;
}

Vec3 pointOf(const Json& coordinates) {
    return {
        coordinates.at(0).get<double>(),
        coordinates.at(1).get<double>(),
        coordinates.at(2).get<double>()
    };
}

}  // namespace bspline_curve::web
