// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/description_reader.h"

#include <stdexcept>
#include <utility>

namespace bspline_curve {

using nlohmann::json;

DescriptionReader::DescriptionReader(const json& object, std::string place)
    : object_(object), place_(std::move(place)) {
    if (!object_.is_object()) {
        refuse("is no object");
    }
}

void DescriptionReader::refuse(const std::string& what) const {
    throw std::invalid_argument("description of the filters: " + place_ + " " + what);
}

const json& DescriptionReader::at(const char* key) {
    known_.insert(key);
    const auto found = object_.find(key);
    if (found == object_.end()) {
        refuse(std::string("has no ") + key);
    }
    return *found;
}

const json& DescriptionReader::any(const char* key) {
    return at(key);
}

std::string DescriptionReader::text(const char* key) {
    const json& value = at(key);
    if (!value.is_string() || value.get_ref<const std::string&>().empty()) {
        refuse(std::string("has a ") + key + " that is no text");
    }
    return value.get<std::string>();
}

std::string DescriptionReader::textOr(const char* key, const std::string& otherwise) {
    return has(key) ? text(key) : otherwise;
}

bool DescriptionReader::flagOr(const char* key, bool otherwise) {
    if (!has(key)) {
        return otherwise;
    }
    const json& value = at(key);
    if (!value.is_boolean()) {
        refuse(std::string("has a ") + key + " that is neither true nor false");
    }
    return value.get<bool>();
}

int DescriptionReader::countOr(const char* key, int otherwise) {
    if (!has(key)) {
        return otherwise;
    }
    const json& value = at(key);
    if (!value.is_number_integer() || value.get<int>() < 0) {
        refuse(std::string("has a ") + key + " that is no whole number of 0 or more");
    }
    return value.get<int>();
}

std::optional<double> DescriptionReader::number(const char* key) {
    if (!has(key)) {
        return std::nullopt;
    }
    const json& value = at(key);
    if (!value.is_number()) {
        refuse(std::string("has a ") + key + " that is no number");
    }
    return value.get<double>();
}

std::vector<std::string> DescriptionReader::texts(const char* key) {
    const json& list = at(key);
    std::vector<std::string> result;
    for (const json& value : list) {
        if (!value.is_string()) {
            refuse(std::string("has ") + key + " that are no texts");
        }
        result.push_back(value.get<std::string>());
    }
    if (!list.is_array() || result.empty()) {
        refuse(std::string("has ") + key + " that are no list of texts");
    }
    return result;
}

DescriptionReader DescriptionReader::object(const char* key) {
    return {at(key), place_ + "." + key};
}

std::vector<DescriptionReader> DescriptionReader::objects(const char* key) {
    std::vector<DescriptionReader> result;
    if (!has(key)) {
        return result;
    }
    const json& list = at(key);
    if (!list.is_array()) {
        refuse(std::string("has ") + key + " that are no list");
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        result.emplace_back(list[i], place_ + "." + key + "[" + std::to_string(i) + "]");
    }
    return result;
}

void DescriptionReader::end() const {
    for (const auto& [key, value] : object_.items()) {
        if (!known_.contains(key)) {
            refuse("has an unknown key " + key);
        }
    }
}

}  // namespace bspline_curve
