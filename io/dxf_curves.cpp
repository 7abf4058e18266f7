// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dxf_curves.h"

#include "io/dxf_entities.h"
#include "io/dxf_path.h"
#include "io/left_out.h"
#include "pattern/drawing.h"
#include "text/text_parsing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kRadians = std::numbers::pi / 180.0;
/// Blocks in blocks, at most.
constexpr std::size_t kMostDepth = 64;
/// Entities and their arcs that blocks in blocks come to, at most: files of a kilobyte can ask for
/// any number.
constexpr std::size_t kMostInserted = 1000000;
/// An entity in a block that cannot be drawn counts as so many: a large array of it shows nothing,
/// and is soon refused.
constexpr std::size_t kPartsOfLeftOut = 10;

/// Entities that show something, but are no curves of this reader.
constexpr std::array<std::string_view, 7> kDxfLeftOut{
    "TEXT", "MTEXT", "HATCH", "DIMENSION", "LEADER", "MLINE", "HELIX"
};

class DxfCurveReader {
public:
    DxfCurveReader(
        const std::filesystem::path& file,
        const DxfContent& content,
        const std::vector<std::string>& layers
    )
        : file_(file), leftOut_(file) {
        for (const std::string& layer : layers) {
            wanted_.insert(lowerCase(layer));
        }
        for (const DxfEntity& entry : content.tables) {
            if (entry.name() == "LAYER") {
                constexpr int kFrozen = 1;
                const std::string name = lowerCase(entry.textOf(2));
                layers_.insert(name);
                if (entry.integerOf(62, 1) < 0 || (entry.flags() & kFrozen) != 0) {
                    hiddenLayers_.insert(name);
                }
            }
        }
        collectBlocks(content);
        checkLayers(content, layers);
    }

    DxfCurves read(std::span<const DxfEntity> entities) {
        drawAll(entities, {.map = Eigen::Affine3d::Identity(), .layer = "0"});
        if (curves_.paths.empty()) {
            refuseEmpty();
        }
        for (const auto& [name, count] : others_) {
            curves_.notes.push_back(
                file_.filename().string() + ": " + std::to_string(count) + " " + name +
                " left out; turn text and hatches into lines in your drawing program"
            );
        }
        if (hidden_ > 0) {
            curves_.notes.push_back(
                file_.filename().string() + ": " + std::to_string(hidden_) +
                (hidden_ == 1 ? " entity" : " entities") + kHiddenWhere + " left out"
            );
        }
        if (!leftOut_.empty()) {
            curves_.notes.push_back(leftOut_.note("entity", "entities"));
        }
        return std::move(curves_);
    }

private:
    static constexpr const char* kHiddenWhere =
        " in paper space, invisible, or on layers that are off, frozen or not asked for";

    struct Block {
        Vec3 base;
        std::span<const DxfEntity> entities;
    };

    /// Where entities are drawn: what the entities of the layer 0 of a block take over.
    struct Placing {
        Eigen::Affine3d map;
        std::string layer;
    };

    void collectBlocks(const DxfContent& content) {
        for (std::size_t i = 0; i < content.blocks.size(); ++i) {
            if (content.blocks[i].name() != "BLOCK") {
                continue;
            }
            std::size_t end = i + 1;
            while (end < content.blocks.size() && content.blocks[end].name() != "ENDBLK") {
                ++end;
            }
            blocks_.emplace(
                lowerCase(content.blocks[i].textOf(2)),
                Block{
                    .base = content.blocks[i].pointOf(10),
                    .entities = std::span(content.blocks).subspan(i + 1, end - i - 1)
                }
            );
            i = end;
        }
    }

    /// Refuses names of layers that the file does not have.
    void checkLayers(const DxfContent& content, const std::vector<std::string>& asked) {
        for (const auto* const list : {&content.entities, &content.blocks}) {
            for (const DxfEntity& entity : *list) {
                layers_.insert(layerNamed(entity));
            }
        }
        for (const std::string& layer : asked) {
            if (!layers_.contains(lowerCase(layer))) {
                std::string known;
                for (const std::string& each : layers_) {
                    known.append(known.empty() ? "" : ", ").append(each);
                }
                refuseFile(file_, "has no layer " + inQuotes(layer) + " but " + known);
            }
        }
    }

    [[noreturn]] void refuseEmpty() const {
        if (!leftOut_.empty()) {
            leftOut_.refuse();
        }
        std::string reason = "has no curve";
        if (hidden_ > 0) {
            reason += ": all its entities are" + std::string(kHiddenWhere);
        } else if (!others_.empty()) {
            reason += "; turn text and hatches into lines in your drawing program";
        }
        refuseFile(file_, reason);
    }

    static std::string layerNamed(const DxfEntity& entity) {
        const std::string_view name = entity.textOf(8);
        return name.empty() ? "0" : lowerCase(name);
    }

    /// The layer that an entity shows on.
    static std::string layerOf(const DxfEntity& entity, const Placing& placing) {
        const std::string name = layerNamed(entity);
        return name == "0" ? placing.layer : name;
    }

    [[nodiscard]] bool isHidden(const DxfEntity& entity, const Placing& placing) const {
        if (entity.integerOf(60, 0) != 0 || entity.integerOf(67, 0) != 0) {
            return true;
        }
        const std::string layer = layerOf(entity, placing);
        if (!wanted_.empty()) {
            // A block is looked into: what it holds has layers of its own.
            return entity.name() != "INSERT" && !wanted_.contains(layer);
        }
        return hiddenLayers_.contains(layer);
    }

    void drawAll(std::span<const DxfEntity> entities, const Placing& placing) {
        for (std::size_t i = 0; i < entities.size(); ++i) {
            const DxfEntity& entity = entities[i];
            std::size_t end = i + 1;
            while (entity.name() == "POLYLINE" && end < entities.size() &&
                   entities[end].name() == "VERTEX") {
                ++end;
            }
            const std::span<const DxfEntity> vertices = entities.subspan(i + 1, end - i - 1);
            i = end - 1;
            count(1);
            const auto known = unreadable_.find({&entity, placing.layer});
            if (known != unreadable_.end()) {
                leaveOut(known->second);
                continue;
            }
            SpacePath path;
            try {
                const bool isInsert = entity.name() == "INSERT";
                if (isHidden(entity, placing)) {
                    hidden_ += isInsert || isDxfCurve(entity) ? 1 : 0;
                    continue;
                }
                if (!isInsert) {
                    countOther(entity);
                    path = mapped(pathOfDxf(entity, vertices), placing.map);
                }
            } catch (const InputError& error) {
                unreadable_.insert({{&entity, placing.layer}, error});
                leaveOut(error);
                continue;
            }
            if (entity.name() == "INSERT") {
                insert(entity, placing);
            }
            add(std::move(path), entity);
        }
    }

    void countOther(const DxfEntity& entity) {
        if (std::ranges::find(kDxfLeftOut, entity.name()) != kDxfLeftOut.end()) {
            ++others_[std::string(entity.name())];
        }
    }

    void add(SpacePath&& path, const DxfEntity& entity) {
        count(path.arcs.size());
        const bool isUsable = std::ranges::all_of(path.arcs, [](const SpaceArc& arc) {
            return std::ranges::all_of(arc.points, [](const Vec3& point) {
                return point.cwiseAbs().maxCoeff() <= kLargestDrawingCoordinate &&
                       point.allFinite();
            });
        });
        if (!isUsable) {
            leftOut_.add(entity.line(), "its numbers are too large");
        } else if (!path.arcs.empty()) {
            curves_.paths.push_back(std::move(path));
        }
    }

    void leaveOut(const InputError& error) {
        leftOut_.add(error);
        count(kPartsOfLeftOut);
    }

    /// Counts what blocks bring.
    void count(std::size_t parts) {
        inserted_ += open_.empty() ? 0 : parts;
        if (inserted_ > kMostInserted) {
            refuseFile(
                file_,
                "blocks in blocks come to more than " + std::to_string(kMostInserted) +
                    " entities; explode what you need into a file of its own"
            );
        }
    }

    void insert(const DxfEntity& entity, const Placing& outer) {
        const std::string name = lowerCase(entity.textOf(2));
        const auto found = blocks_.find(name);
        if (found == blocks_.end()) {
            leftOut_.add(entity.line(), "there is no block " + inQuotes(entity.textOf(2)));
            return;
        }
        if (open_.contains(name) || open_.size() >= kMostDepth) {
            leftOut_.add(entity.line(), "blocks insert each other without end");
            return;
        }
        Placing inner{.map = outer.map, .layer = layerOf(entity, outer)};
        open_.insert(name);
        try {
            const Vec3 at = entity.pointOf(10);
            const Vec2 steps(entity.numberOf(44, 0.0), entity.numberOf(45, 0.0));
            const int columns = std::max(1, entity.integerOf(70, 1));
            const int rows = std::max(1, entity.integerOf(71, 1));
            const double angle = entity.numberOf(50, 0.0) * kRadians;
            const Vec3 scale(
                entity.numberOf(41, 1.0), entity.numberOf(42, 1.0), entity.numberOf(43, 1.0)
            );
            for (int column = 0; column < columns; ++column) {
                for (int row = 0; row < rows; ++row) {
                    count(1);
                    inner.map = outer.map * ownDxfPlane(entity, 0.0);
                    inner.map.translate(at)
                        .rotate(Eigen::AngleAxisd(angle, Vec3::UnitZ()))
                        .translate(Vec3(column * steps.x(), row * steps.y(), 0.0))
                        .scale(scale)
                        .translate(-found->second.base);
                    drawAll(found->second.entities, inner);
                }
            }
        } catch (const InputError& error) {
            open_.erase(name);
            if (inserted_ > kMostInserted) {
                throw;
            }
            unreadable_.insert({{&entity, outer.layer}, error});
            leaveOut(error);
            return;
        }
        open_.erase(name);
    }

    const std::filesystem::path& file_;
    std::map<std::string, Block, std::less<>> blocks_;
    std::set<std::string> layers_, hiddenLayers_, wanted_;
    std::set<std::string> open_;  // blocks that are being drawn
    // By the layer of the insert, which may hide them: no copy in a block is tried again.
    std::map<std::pair<const DxfEntity*, std::string>, InputError> unreadable_;
    DxfCurves curves_;
    std::map<std::string, int> others_;
    LeftOut leftOut_;
    std::size_t inserted_ = 0;
    int hidden_ = 0;
};

}  // namespace

DxfCurves curvesOfDxf(
    const std::filesystem::path& file,
    std::string_view bytes,
    const std::vector<std::string>& layers
) {
    const DxfContent content = dxfContent(file, bytes);
    return DxfCurveReader(file, content, layers).read(content.entities);
}

}  // namespace bspline_curve
