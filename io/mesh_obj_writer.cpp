// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as OBJ: text, the shortest decimals that read back as the same doubles.
#include "io/mesh_formats.h"
#include "text/number_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// The values of a channel of vertices; null: there is none of these names.
const std::vector<double>* valuesNamed(
    const MeshExtras* extras, std::initializer_list<std::string_view> names
) {
    if (extras != nullptr) {
        for (const MeshChannel& channel : extras->vertices) {
            if (std::ranges::find(names, channel.name) != names.end()) {
                return &channel.values;
            }
        }
    }
    return nullptr;
}

/// Statements of OBJ that give corners a vector, each vector once, and their indices from 1.
class ObjVectors {
public:
    explicit ObjVectors(std::string keyword) : keyword_(std::move(keyword)) {}

    std::size_t indexOf(const std::vector<double>& values) {
        const auto [entry, isNew] = indices_.try_emplace(values, indices_.size() + 1);
        if (isNew) {
            text_ += keyword_;
            for (const double value : values) {
                text_.append(" ").append(numberText(value));
            }
            text_ += '\n';
        }
        return entry->second;
    }

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string keyword_, text_;
    std::map<std::vector<double>, std::size_t> indices_;
};

/// Three channels of vertices; none where one of them is missing.
using VectorChannels = std::array<const std::vector<double>*, 3>;

bool isWhole(const VectorChannels& channels) {
    return std::ranges::find(channels, nullptr) == channels.end();
}

class ObjMesh {
public:
    ObjMesh(const TriangleMesh& mesh, const MeshExtras* extras)
        : mesh_(mesh),
          extras_(extras),
          colours_{
              valuesNamed(extras, {"red"}),
              valuesNamed(extras, {"green"}),
              valuesNamed(extras, {"blue"})
          },
          normals_{
              valuesNamed(extras, {"nx"}), valuesNamed(extras, {"ny"}), valuesNamed(extras, {"nz"})
          },
          u_(valuesNamed(extras, {"s", "u", "texture_u"})),
          v_(valuesNamed(extras, {"t", "v", "texture_v"})),
          hasCornerTexture_(extras != nullptr && !extras->cornerTexture.empty()),
          hasCornerNormals_(extras != nullptr && !extras->cornerNormals.empty()),
          hasTexture_(hasCornerTexture_ || (u_ != nullptr && v_ != nullptr)),
          hasNormals_(hasCornerNormals_ || isWhole(normals_)) {}

    std::string run() {
        std::string text;
        if (extras_ != nullptr) {
            for (const std::string& library : extras_->libraries) {
                text.append("mtllib ").append(library).append("\n");
            }
        }
        addVertices(text);
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            addHeading(f);
            faces_ += 'f';
            for (std::size_t k = 0; k < 3; ++k) {
                addCorner(f, k);
            }
            faces_ += '\n';
        }
        return text + textures_.text() + directions_.text() + faces_;
    }

private:
    void addVertices(std::string& text) const {
        constexpr double kBrightest = 255.0;
        const bool hasColours = isWhole(colours_);
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
            text += 'v';
            for (const double x : mesh_.vertices[v]) {
                text.append(" ").append(numberText(x));
            }
            for (std::size_t k = 0; hasColours && k < 3; ++k) {
                text.append(" ").append(numberText((*colours_[k])[v] / kBrightest));
            }
            text += '\n';
        }
    }

    void addHeading(std::size_t f) {
        if (extras_ == nullptr || extras_->headingOf.empty()) {
            return;
        }
        const int heading = extras_->headingOf[f];
        if (heading >= 0 && heading != heading_) {
            heading_ = heading;
            faces_ += extras_->headings[heading];
        }
    }

    void addCorner(std::size_t f, std::size_t k) {
        const int vertex = mesh_.faces[f][k];
        faces_.append(" ").append(std::to_string(vertex + 1));
        if (hasTexture_) {
            const Eigen::Vector2d place = hasCornerTexture_
                                              ? extras_->cornerTexture[f][k]
                                              : Eigen::Vector2d((*u_)[vertex], (*v_)[vertex]);
            faces_.append("/").append(std::to_string(textures_.indexOf({place.x(), place.y()})));
        }
        if (hasNormals_) {
            const Vec3 normal =
                hasCornerNormals_
                    ? extras_->cornerNormals[f][k]
                    : Vec3((*normals_[0])[vertex], (*normals_[1])[vertex], (*normals_[2])[vertex]);
            faces_.append(hasTexture_ ? "/" : "//");
            faces_ += std::to_string(directions_.indexOf({normal.x(), normal.y(), normal.z()}));
        }
    }

    const TriangleMesh& mesh_;
    const MeshExtras* extras_;
    VectorChannels colours_, normals_;
    const std::vector<double>*u_, *v_;
    bool hasCornerTexture_, hasCornerNormals_, hasTexture_, hasNormals_;
    ObjVectors textures_{"vt"}, directions_{"vn"};
    std::string faces_;
    int heading_ = -1;  // the last one that was written
};

}  // namespace

std::string meshObj(const TriangleMesh& mesh, const MeshAttributes& attributes) {
    return ObjMesh(mesh, attributes.extras).run();
}

}  // namespace bspline_curve
