// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/face_labels.h"

#include "bspline_curve/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace bspline_curve {

namespace {

int rounded(double quality) {
    const double label = std::round(quality);
    if (!(std::abs(label) <= static_cast<double>(std::numeric_limits<int>::max()))) {
        throw InputError(
            InputErrorCode::BadField,
            "a quality that labels a face is not finite, or no number of a label"
        );
    }
    return static_cast<int>(label);
}

void requireMask(const MeshModel& layer, int mask, const std::string& what) {
    if (!layer.hasDataMask(mask)) {
        throw InputError(
            InputErrorCode::BadField,
            "layer \"" + layer.label().toStdString() + "\" has no " + what +
                ": choose other boundaries by the option boundaries"
        );
    }
}

// The label of most vertices, else the least one.
int commonLabel(const MeshModel& layer, const CFaceO& face) {
    std::array<int, 3> labels{};
    for (int k = 0; k < 3; ++k) {
        labels[static_cast<std::size_t>(k)] =
            rounded(static_cast<double>(layer.cm.vert[vcg::tri::Index(layer.cm, face.cV(k))].cQ()));
    }
    std::ranges::sort(labels);
    return labels[1] == labels[2] ? labels[1] : labels[0];
}

}  // namespace

std::vector<int> faceLabels(const MeshModel& layer, const LayerArrays& arrays, FaceLabels labels) {
    if (labels == FaceLabels::Selection) {
        const std::vector<char>& selected = arrays.input.selectedFaces;
        return {selected.begin(), selected.end()};
    }
    if (labels == FaceLabels::FaceQuality) {
        requireMask(layer, MeshModel::MM_FACEQUALITY, "quality of faces");
    } else if (labels == FaceLabels::FaceColour) {
        requireMask(layer, MeshModel::MM_FACECOLOR, "colours of faces");
    } else {
        requireMask(layer, MeshModel::MM_VERTQUALITY, "quality of vertices");
    }
    std::map<std::array<std::uint8_t, 4>, int> colours;
    std::vector<int> found;
    found.reserve(arrays.faceIds.size());
    for (const int id : arrays.faceIds) {
        const CFaceO& face = layer.cm.face[id];
        if (labels == FaceLabels::FaceQuality) {
            found.push_back(rounded(static_cast<double>(face.cQ())));
        } else if (labels == FaceLabels::FaceColour) {
            const vcg::Color4b& colour = face.cC();
            const auto next = static_cast<int>(colours.size());
            found.push_back(
                colours.emplace(std::array{colour[0], colour[1], colour[2], colour[3]}, next)
                    .first->second
            );
        } else {
            found.push_back(commonLabel(layer, face));
        }
    }
    return found;
}

}  // namespace bspline_curve
