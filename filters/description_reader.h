// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

/// An object of a description, key by key. All throw std::invalid_argument that names the place and
/// what is wrong there.
class DescriptionReader {
public:
    /// `place`: "filters[0]", for messages. `object` must outlive this.
    DescriptionReader(const nlohmann::json& object, std::string place);

    [[nodiscard]] bool has(const char* key) const { return object_.contains(key); }

    /// A text that is not empty.
    [[nodiscard]] std::string text(const char* key);
    [[nodiscard]] std::string textOr(const char* key, const std::string& otherwise);
    [[nodiscard]] bool flagOr(const char* key, bool otherwise);
    [[nodiscard]] int countOr(const char* key, int otherwise);
    [[nodiscard]] std::optional<double> number(const char* key);
    [[nodiscard]] std::vector<std::string> texts(const char* key);
    [[nodiscard]] DescriptionReader object(const char* key);
    /// Empty where there is no such key.
    [[nodiscard]] std::vector<DescriptionReader> objects(const char* key);
    [[nodiscard]] const nlohmann::json& any(const char* key);

    /// For keys that hosts read for themselves.
    void ignore(const char* key) { known_.insert(key); }

    /// Refuses keys that nothing asked for.
    void end() const;

    [[noreturn]] void refuse(const std::string& what) const;

private:
    [[nodiscard]] const nlohmann::json& at(const char* key);

    const nlohmann::json& object_;
    std::string place_;
    std::set<std::string, std::less<>> known_;
};

}  // namespace bspline_curve
