// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/curve_uses.h"

#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/surface_choice.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

namespace bspline_curve {
namespace {

std::set<int> layerIds(const MeshDocument& document) {
    std::set<int> ids;
    for (const MeshModel* const layer : host::layersOf(document)) {
        ids.insert(layer->id());
    }
    return ids;
}

/// Hides the polylines that are not meant, for a filter that uses all that are visible.
class OtherPolylines {
public:
    OtherPolylines(MeshDocument& document, const std::vector<int>& meant) : document_(document) {
        for (const MeshModel* const layer : host::layersOf(document)) {
            if (isPolyline(*layer) && layer->isVisible() &&
                std::ranges::find(meant, layer->id()) == meant.end()) {
                hidden_.push_back(layer->id());
            }
        }
        setVisible(false);
    }

    ~OtherPolylines() { setVisible(true); }

    OtherPolylines(const OtherPolylines&) = delete;
    OtherPolylines& operator=(const OtherPolylines&) = delete;

private:
    void setVisible(bool isVisible) {
        for (const int layer : hidden_) {
            document_.setVisible(layer, isVisible);
        }
    }

    MeshDocument& document_;
    std::vector<int> hidden_;
};

/// A step of a filter; what it throws is told as the filter's failure.
template <class Step>
void run(const FilterDescription& filter, const Step& step) {
    try {
        step();
    } catch (const std::exception& error) {
        throw std::runtime_error(failureOf(filter, error));
    }
}

}  // namespace

void CurveUses::start(const FilterDescription& filter) {
    cancel();
    const std::vector<int> curves = layers_.shownLayers();
    if (curves.empty()) {
        throw std::runtime_error("there is no curve: draw one first");
    }
    parameters_ = dialogParameters(filter, document_, host::offeredToScripts(filter));
    // Its own surface stands for all polylines that are visible.
    const int layer = curves.size() == 1 ? curves.front() : surface_;
    setParameter(parameters_, filter.parameter("surface_layer"), LayerId{surface_}, document_);
    setParameter(parameters_, filter.parameter("curve_layer"), LayerId{layer}, document_);
    run(filter, [&] {
        const OtherPolylines hidden(document_, curves);
        // None of these filters draws curves, so none needs workpieces of before.
        WorkpieceCache none;
        running_ = std::make_unique<FilterBeside>(
            filter, startOnDocument(filter, document_, parameters_, none)
        );
    });
}

bool CurveUses::waits() const {
    return !toShow_.empty() || (running_ && running_->isReady());
}

bool CurveUses::step() {
    if (running_ && running_->isReady()) {
        bring();
    } else if (!toShow_.empty()) {
        layers_.showNew(toShow_.back());
        toShow_.pop_back();
        return toShow_.empty();
    }
    return false;
}

void CurveUses::bring() {
    const std::unique_ptr<FilterBeside> ready = std::move(running_);
    const std::set<int> before = layerIds(document_);
    run(ready->filter(),
        [&] { layers_.tellOfFilter(ready->filter(), parameters_, ready->bring().log); });
    std::ranges::set_difference(layerIds(document_), before, std::back_inserter(toShow_));
}

bool CurveUses::cancel() {
    return std::exchange(running_, nullptr) != nullptr;
}

void CurveUses::finish() {
    if (running_) {
        layers_.say(
            "\"" + running_->filter().name + "\" was stopped, since the drawing tool ended."
        );
        cancel();
    }
    for (const int layer : std::exchange(toShow_, {})) {
        if (host::layerWithId(document_, layer) != nullptr) {
            layers_.showNew(layer);
        }
    }
}

}  // namespace bspline_curve
