// SPDX-License-Identifier: GPL-3.0-or-later
// hot_paths NAME: runs one path twice on a generated mesh, the second time within runMeasured(),
// for callgrind (count_instructions.py). hot_paths --list: the names, a line each with items per
// run and what they are. hot_paths --about: compiler, flags and processor, a line each.
#include "benchmarks/paths.h"
#include "benchmarks/scene.h"
#include "utility/worker_task.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace bspline_curve::benchmarks;

constexpr int kSubdivisions = 5;  // 20,480 faces
// Callgrind counts what the calling thread does alone.
static_assert((20U << (2U * kSubdivisions)) < bspline_curve::kFacesForTwoThreads);

}  // namespace

// Callgrind knows it by this name.
extern "C" [[gnu::noinline]] void runMeasured(const MeasuredPath* path) {
    path->run();
}

namespace {

int runPath(const std::string& name) {
    const Scene scene(kSubdivisions);
    const std::vector<MeasuredPath> paths = measuredPaths(scene);
    if (name == "--list") {
        for (const MeasuredPath& path : paths) {
            std::cout << path.name << '\t' << path.items << '\t' << path.item << '\n';
        }
        return 0;
    }
    const auto found = std::ranges::find(paths, name, &MeasuredPath::name);
    if (found == paths.end()) {
        std::cerr << "hot_paths: no path is called " << name << ": see hot_paths --list\n";
        return 2;
    }
    found->run();  // what is kept from run to run is there
    runMeasured(&*found);
    return 0;
}

}  // namespace

int main(int count, char** words) {
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments.size() != 1) {
        std::cerr << "usage: hot_paths NAME | --list | --about\n";
        return 2;
    }
    if (arguments.front() == "--about") {
        std::cout << "compiler\t" BENCHMARKED_COMPILER "\nflags\t" BENCHMARKED_FLAGS
                     "\nprocessor\t" BENCHMARKED_PROCESSOR "\n";
        return 0;
    }
    try {
        return runPath(arguments.front());
    } catch (const std::exception& error) {
        std::cerr << "hot_paths: " << error.what() << '\n';
        return 1;
    }
}
