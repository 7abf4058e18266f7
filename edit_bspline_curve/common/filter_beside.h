// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/run_on_document.h"

#include <QMetaObject>
#include <atomic>
#include <future>
#include <memory>

namespace bspline_curve {

/// A filter that computes on a thread of its own, beside the window.
class FilterBeside {
public:
    FilterBeside(const FilterDescription& filter, FilterComputing computing);

    /// Gives it up. The thread, which touches nothing of others, may end a little later, but before
    /// the program does.
    ~FilterBeside();

    FilterBeside(const FilterBeside&) = delete;
    FilterBeside& operator=(const FilterBeside&) = delete;

    [[nodiscard]] const FilterDescription& filter() const { return filter_; }

    /// The share of the work that is done, from 0 to 1.
    [[nodiscard]] double done() const { return shared_->done; }

    [[nodiscard]] bool isReady() const;

    /// The last step of the filter, once it is ready. Throws what computing threw.
    [[nodiscard]] FilterAnswer bring() const { return bringing_.get()(); }

private:
    struct Shared {
        std::atomic<double> done = 0.0;
        std::atomic<bool> isGivenUp = false;
    };

    const FilterDescription& filter_;
    std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
    std::shared_future<FilterBringing> bringing_;
    QMetaObject::Connection quitting_;
};

}  // namespace bspline_curve
