// SPDX-License-Identifier: GPL-3.0-or-later
// How long a drawing session takes from a mouse event to the curve: one pick of a curve is dragged
// over the surface in steps of a fifth of an edge, and each event waits for the one before.
#include "bspline_curve/drawing_session.h"
#include "bspline_curve/files.h"
#include "surface/picks.h"
#include "utility/stopwatch.h"
#include "workpiece/workpiece_parts.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <iostream>
#include <memory>
#include <mutex>
#include <vector>

namespace bspline_curve::benchmarks {
namespace {

// Lets the thread that draws sleep until there is something to draw.
class Bell {
public:
    void ring() {
        {
            const std::scoped_lock lock(mutex_);
            hasRung_ = true;
        }
        condition_.notify_one();
    }

    void wait() {
        std::unique_lock lock(mutex_);
        condition_.wait(lock, [this] { return hasRung_; });
        hasRung_ = false;
    }

private:
    std::mutex mutex_;
    std::condition_variable condition_;
    bool hasRung_ = false;
};

// A ray that meets the surface at a point, from outside.
Pointer pointerAt(const Surface& surface, const SurfacePoint& point) {
    Pointer pointer;
    const double height = 1e-3 * surface.diagonal();
    pointer.direction = -surface.faceNormal(point.face);
    pointer.start = surface.position(point) - height * pointer.direction;
    pointer.pixel = 1e-3 * surface.diagonal();
    pointer.isOrthographic = true;
    return pointer;
}

// Points along the surface, so many steps of a length from a pick towards the next and back.
std::vector<SurfacePoint> wayFrom(
    const CurveDesigner& designer, const Curve& curve, int pick, double step, int count
) {
    const SurfacePolyline& line = curve.polyline;
    const Vec3 from = line.points[line.picks[pick]];
    const Surface& surface = designer.surface();
    // Away from the curve: across it, in the tangent plane.
    const auto here = static_cast<std::size_t>(line.picks[pick]);
    const Vec3 along = (line.points[here + 1] - line.points[here]).normalized();
    const Vec3 across = surface.faceNormal(line.surfacePoints[here].face).cross(along);
    std::vector<SurfacePoint> way;
    for (int i = 1; i <= count; ++i) {
        const int steps = i <= count / 2 ? i : count - i;
        way.push_back(designer.tree().closestPoint(from + steps * step * across).point);
    }
    return way;
}

nlohmann::ordered_json measure(
    const std::string& meshFile, const std::string& picksFile, int count
) {
    TriangleMesh mesh = readMesh(meshFile);
    const PicksFile input = readPicks(picksFile);
    Stopwatch watch;
    const auto workpiece = std::make_shared<const Workpiece>(std::move(mesh));
    const CurveDesigner& designer = designerOf(*workpiece);
    Bell bell;
    SessionSettings settings;
    settings.wake = [&bell] { bell.ring(); };
    DrawingSession session(workpiece, settings);
    const Surface& surface = designer.surface();
    for (const SurfacePoint& pick :
         locatePicks(surface, designer.tree(), input.picks, input.closed.value_or(false)).points) {
        session.addPick(pick);
    }
    session.setClosed(input.closed.value_or(false));
    session.settle();
    const double first = watch.lap();

    const auto middle = static_cast<int>(input.picks.size()) / 2;
    const SketchPick start = session.sketch().activeCurve()->picks[middle];
    const Curve curve = *session.sketch().activeCurve()->settled;
    session.press(pointerAt(surface, start.point));
    std::vector<double> seconds;
    for (const SurfacePoint& point :
         wayFrom(designer, curve, middle, 0.2 * surface.averageEdgeLength(), count)) {
        watch.lap();
        session.move(pointerAt(surface, point));
        if (session.isDragging()) {
            bell.wait();
            session.update();
            seconds.push_back(watch.lap());
        }
    }
    session.release(pointerAt(surface, start.point));
    session.settle();
    std::ranges::sort(seconds);
    const auto at = [&](double share) {
        return 1e3 *
               seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
    };
    return {
        {"mesh", meshFile},
        {"faces", surface.faceCount()},
        {"events", seconds.size()},
        {"first_curve_ms", 1e3 * first},
        {"median_ms", at(0.5)},
        {"p95_ms", at(0.95)},
        {"worst_ms", at(1.0)}
    };
}

}  // namespace
}  // namespace bspline_curve::benchmarks

int main(int argc, char** argv) {
    try {
        CLI::App app("Measures the latency of dragging a pick");
        std::string mesh;
        std::string picks;
        int count = 200;
        app.add_option("MESH", mesh, "Mesh")->required();
        app.add_option("PICKS", picks, "Picks")->required();
        app.add_option("--events", count, "Mouse events")->capture_default_str();
        CLI11_PARSE(app, argc, argv);
        std::cout << bspline_curve::benchmarks::measure(mesh, picks, count).dump(1) << '\n';
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
