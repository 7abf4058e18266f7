// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_formats.h"
#include "text/number_text.h"

namespace bspline_curve {

std::string curveCsv(const CurveContent& content) {
    const SurfacePolyline& polyline = content.curve.polyline;
    const std::vector<char> isPick = pickFlags(polyline);
    std::string bytes = "x,y,z,t,face,b0,b1,b2,quality,is_pick\n";
    for (std::size_t i = 0; i < polyline.points.size(); ++i) {
        for (const double x : polyline.points[i]) {
            bytes.append(numberText(x)).append(",");
        }
        bytes.append(numberText(polyline.parameters[i])).append(",");
        bytes.append(std::to_string(polyline.surfacePoints[i].face)).append(",");
        for (const double b : polyline.surfacePoints[i].barycentric) {
            bytes.append(numberText(b)).append(",");
        }
        bytes.append(numberText(content.quality()[i])).append(isPick[i] != 0 ? ",1\n" : ",0\n");
    }
    return bytes;
}

}  // namespace bspline_curve
