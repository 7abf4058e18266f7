// SPDX-License-Identifier: GPL-3.0-or-later
// Times of single steps on generated meshes: NAME/FACES, with items (faces, samples …) per second.
#include "benchmarks/paths.h"
#include "benchmarks/scene.h"

#include <benchmark/benchmark.h>

#include <array>
#include <deque>
#include <string>

namespace {

using namespace bspline_curve::benchmarks;

constexpr std::array kSubdivisions = {4, 6};

void add(const MeasuredPath& path, int faces) {
    benchmark::RegisterBenchmark(
        (path.name + "/" + std::to_string(faces)).c_str(), [path](benchmark::State& state) {
            for (auto turn : state) {
                path.run();
            }
            state.SetItemsProcessed(state.iterations() * path.items);
            state.SetLabel("items: " + path.item);
        }
    )->Unit(benchmark::kMicrosecond);
}

}  // namespace

int main(int count, char** words) {
    benchmark::Initialize(&count, words);
    if (benchmark::ReportUnrecognizedArguments(count, words)) {
        return 2;
    }
    std::deque<Scene> scenes;
    for (const int subdivisions : kSubdivisions) {
        const Scene& scene = scenes.emplace_back(subdivisions);
        for (const MeasuredPath& path : measuredPaths(scene)) {
            add(path, scene.prepared.surface().faceCount());
        }
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
