// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/picked_points.h"

#include <QString>
#include <string>

// The tool keeps its points as a per-mesh attribute, a pointer to a class of its own. MeshLab
// installs no header for it; an attribute is found by its name and the name of its type. So these
// two classes, in the global namespace, have the names and the layout of
// edit_pickpoints/pickedPoints.h, the same in MeshLab 2020.09 to 2025.07.
class PickedPoint {
public:
    QString name;
    bool present;
    Point3m point;
};

class PickedPoints {
public:
    std::vector<PickedPoint*> points;
    QString templateName;
};

namespace bspline_curve {

std::vector<Point3m> pickedPointsOf(const CMeshO& mesh) {
    std::vector<Point3m> result;
    const auto* const attribute = host::perMeshAttribute<PickedPoints*>(mesh, "PickedPoints");
    if (attribute == nullptr || *attribute == nullptr) {
        return result;
    }
    for (const PickedPoint* pick : (*attribute)->points) {
        if (pick->present) {
            result.push_back(pick->point);
        }
    }
    return result;
}

}  // namespace bspline_curve
