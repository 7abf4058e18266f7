// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/filter_beside.h"

#include "bspline_curve/progress.h"

#include <QCoreApplication>
#include <chrono>
#include <utility>

namespace bspline_curve {

FilterBeside::FilterBeside(const FilterDescription& filter, FilterComputing computing)
    : filter_(filter),
      bringing_(
          std::async(
              std::launch::async,
              [shared = shared_, computing = std::move(computing)]() mutable {
                  // What it took is given back here as well.
                  const FilterComputing compute = std::move(computing);
                  const Progress progress = [&shared](double fraction, const char*) {
                      shared->done = fraction;
                      return !shared->isGivenUp;
                  };
                  FilterBringing bringing = compute(progress);
                  report(progress, 1.0, "");  // nobody is to keep what nobody wants
                  return bringing;
              }
          ).share()
      ),
      quitting_(
          QObject::connect(
              qApp, &QCoreApplication::aboutToQuit, qApp, [shared = shared_, bringing = bringing_] {
                  shared->isGivenUp = true;
                  bringing.wait();
              }
          )
      ) {}

FilterBeside::~FilterBeside() {
    shared_->isGivenUp = true;
    if (isReady()) {
        QObject::disconnect(quitting_);
    }
}

bool FilterBeside::isReady() const {
    return bringing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace bspline_curve
