// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dxf_entities.h"

#include "text/text_parsing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace bspline_curve {

namespace {

class DxfReader {
public:
    DxfReader(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), lines_(bytes) {}

    DxfContent read() {
        bool isSectionStart = false;
        while (const std::optional<DxfPair> pair = nextPair()) {
            if (pair->code == 0) {
                isSectionStart = pair->value == "SECTION";
                if (isSectionStart || pair->value == "ENDSEC") {
                    section_ = nullptr;
                } else if (section_ != nullptr) {
                    section_->emplace_back(file_, pair->value, pair->line);
                }
            } else if (isSectionStart && pair->code == 2) {
                begin(pair->value);
                isSectionStart = false;
            } else if (section_ != nullptr && !section_->empty()) {
                section_->back().add(*pair);
            }
        }
        if (!hasEntities_) {
            refuseFile(file_, "has no section ENTITIES; is it a DXF text?");
        }
        return std::move(content_);
    }

private:
    void begin(std::string_view name) {
        if (name == "ENTITIES") {
            section_ = &content_.entities;
            hasEntities_ = true;
        } else if (name == "BLOCKS") {
            section_ = &content_.blocks;
        } else if (name == "TABLES") {
            section_ = &content_.tables;
        }
    }

    std::optional<DxfPair> nextPair() {
        if (!lines_.next()) {
            return std::nullopt;
        }
        DxfPair pair{.code = 0, .value = {}, .line = lines_.number()};
        const std::optional<long long> code = parseInteger(trimmed(lines_.line()));
        if (!code) {
            if (trimmed(lines_.line()).empty()) {
                return std::nullopt;  // blank lines at the end
            }
            refuseLine(
                file_, pair.line, inQuotes(lines_.line()) + " is no group code; is it a DXF text?"
            );
        }
        if (!lines_.next()) {
            refuseLine(file_, pair.line, "the file ends after a group code");
        }
        pair.code = static_cast<int>(*code);
        pair.value = trimmed(lines_.line());
        return pair;
    }

    const std::filesystem::path& file_;
    LineReader lines_;
    DxfContent content_;
    std::vector<DxfEntity>* section_ = nullptr;
    bool hasEntities_ = false;
};

}  // namespace

double DxfEntity::number(const DxfPair& pair) const {
    const std::optional<double> value = parseNumber(pair.value);
    if (!value || !std::isfinite(*value)) {
        refuseLine(*file_, pair.line + 1, inQuotes(pair.value) + " is not a finite number");
    }
    return *value;
}

double DxfEntity::numberOf(int code, double otherwise) const {
    const auto found = std::ranges::find(pairs_, code, &DxfPair::code);
    return found == pairs_.end() ? otherwise : number(*found);
}

std::vector<double> DxfEntity::numbersOf(int code) const {
    std::vector<double> numbers;
    for (const DxfPair& pair : pairs_) {
        if (pair.code == code) {
            numbers.push_back(number(pair));
        }
    }
    return numbers;
}

std::string_view DxfEntity::textOf(int code) const {
    const auto found = std::ranges::find(pairs_, code, &DxfPair::code);
    return found == pairs_.end() ? std::string_view() : found->value;
}

int DxfEntity::flags() const {
    constexpr int kFlags = 70;
    return integerOf(kFlags, 0);
}

int DxfEntity::integerOf(int code, int otherwise) const {
    using Limits = std::numeric_limits<int>;
    return static_cast<int>(std::clamp(
        numberOf(code, static_cast<double>(otherwise)),
        static_cast<double>(Limits::min()),
        static_cast<double>(Limits::max())
    ));
}

Vec3 DxfEntity::pointOf(int code) const {
    return {numberOf(code, 0.0), numberOf(code + 10, 0.0), numberOf(code + 20, 0.0)};
}

Eigen::Matrix3d DxfEntity::axes() const {
    constexpr double kNearZ = 1.0 / 64.0;
    const Vec3 extrusion(numberOf(210, 0.0), numberOf(220, 0.0), numberOf(230, 1.0));
    if (!(extrusion.norm() > 0.0)) {
        refuse("an extrusion without length");
    }
    const Vec3 z = extrusion.normalized();
    const bool isNearZ = std::abs(z.x()) < kNearZ && std::abs(z.y()) < kNearZ;
    const Vec3 x = (isNearZ ? Vec3::UnitY() : Vec3::UnitZ()).cross(z).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return axes;
}

void DxfEntity::refuse(const std::string& reason) const {
    refuseLine(*file_, line_, reason);
}

DxfContent dxfContent(const std::filesystem::path& file, std::string_view bytes) {
    if (bytes.starts_with("AutoCAD Binary DXF")) {
        refuseFile(file, "is a binary DXF file; save it as text");
    }
    return DxfReader(file, bytes).read();
}

}  // namespace bspline_curve
