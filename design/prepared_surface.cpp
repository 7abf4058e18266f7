// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/prepared_surface.h"

#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "utility/worker_task.h"

#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// Shares of the preparation.
constexpr double kPatchesShare = 0.5;

ShellOptions validated(const ShellOptions& options) {
    options.validate();
    return options;
}

}  // namespace

// Where this thread is stopped, the tasks beside it end at their next report.
template <class Make>
auto PreparedSurface::orEndTasks(const Make& make) {
    try {
        return make();
    } catch (...) {
        isEnding_ = true;
        throw;
    }
}

PreparedSurface::PreparedSurface(
    std::shared_ptr<const Surface> surface,
    const ShellOptions& options,
    const Progress& progress,
    double seconds
)
    : options_(validated(options)),
      surface_(std::move(surface)),
      finestEdge_(kFinestEdge * std::sqrt(surface_->area())),
      validateSeconds_(seconds),
      roughBase_(startBeside([this] { return makeRoughBase(*surface_, untilEnd_); })),
      patches_(orEndTasks([&] {
          return PatchLevels(*surface_, partOf(progress, 0.0, kPatchesShare));
      })),
      futureBase_(startBeside([this] {
          return extendSurface(
              *surface_, roughBase_.get(), options_.smoothingPasses, patches_, untilEnd_
          );
      })),
      tree_(orEndTasks([&] {
          return TriangleTree(
              surface_->vertices(), surface_->faces(), partOf(progress, kPatchesShare, 1.0)
          );
      })),
      treeSeconds_(watch_.lap()),
      extended_(std::make_shared<const ExtendedSurface>(futureBase_.get())),
      baseSeconds_(watch_.lap()) {}

const ObtainedShell& PreparedSurface::wholeShell(
    const Progress& progress, const ShellStore* store
) const {
    const MutexLock lock(wholeMutex_);
    if (!whole_) {
        Stopwatch building;
        ShellOptions whole = options_;
        if (whole.kind == ShellKind::Local) {
            whole.kind = ShellKind::FullResolution;
        }
        auto obtained = std::make_unique<ObtainedShell>(
            findOrMakeShell(*surface_, extended_, whole, store, progress)
        );
        wholeSeconds_ = building.lap();
        keepShell(*surface_, *extended_, whole, store, *obtained);
        whole_ = std::move(obtained);
    }
    return *whole_;
}

const ObtainedShell* PreparedSurface::wholeShellIfBuilt() const {
    const MutexLock lock(wholeMutex_);
    return whole_.get();
}

PreparedSurface::Seconds PreparedSurface::seconds() const {
    const MutexLock lock(wholeMutex_);
    return {validateSeconds_, treeSeconds_, baseSeconds_, wholeSeconds_};
}

}  // namespace bspline_curve
