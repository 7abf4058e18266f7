// SPDX-License-Identifier: GPL-3.0-or-later
// The feet of samples, as a spline moves or gets knots.
#include "solver/sampled_integrals.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace bspline_curve {

std::int64_t SampledIntegrals::follow(const FibreProjector& finder, FootedSpline& spline) const {
    const bool isKnown = !spline.positions.empty();
    spline.positions.resize(sampleCount());
    spline.seconds.resize(sampleCount());
    std::vector<int> spans(space_.spanCount());
    std::iota(spans.begin(), spans.end(), 0);
    return followSpans(finder, isKnown, spans, spline);
}

std::int64_t SampledIntegrals::followRefined(
    const FibreProjector& finder,
    const SampledIntegrals& before,
    const FootedSpline& coarse,
    FootedSpline& spline
) const {
    spline.positions.resize(sampleCount());
    spline.seconds.resize(sampleCount());
    const int perSpan = samplesPerSpan();
    const std::vector<double>& breaks = space_.breaks();
    const std::vector<double>& coarseBreaks = before.space_.breaks();
    std::vector<int> cut;
    int from = 0;  // the span before that this one is or lies in
    for (int span = 0; span < space_.spanCount(); ++span) {
        while (coarseBreaks[from + 1] <= breaks[span]) {
            ++from;
        }
        const bool isWhole =
            coarseBreaks[from + 1] == breaks[span + 1] && coarseBreaks[from] == breaks[span];
        int near = from * perSpan;
        const int last = near + perSpan - 1;
        for (int sample = span * perSpan; sample < (span + 1) * perSpan; ++sample) {
            const auto gapTo = [&](int other) {
                return std::abs(before.parameter(other) - parameter(sample));
            };
            while (near < last && gapTo(near + 1) < gapTo(near)) {
                ++near;
            }
            spline.feet[sample] = coarse.feet[near];
            spline.frames[sample] = coarse.frames[near];
            spline.positions[sample] = coarse.positions[near];
            spline.seconds[sample] = coarse.seconds[near];
        }
        if (!isWhole) {
            cut.push_back(span);
        }
    }
    return followSpans(finder, true, cut, spline);
}

// `isKnown`: the feet are those of the positions.
std::int64_t SampledIntegrals::followSpans(
    const FibreProjector& finder, bool isKnown, std::span<const int> spans, FootedSpline& spline
) const {
    const auto groups = static_cast<int>((spans.size() + kSpansAtOnce - 1) / kSpansAtOnce);
    std::atomic<std::int64_t> facesSeen = 0;
    forEach(problem_.side, groups, 1, [&](int group) {
        const std::size_t first = group * kSpansAtOnce;
        const std::size_t count = std::min(kSpansAtOnce, spans.size() - first);
        std::array<FibreProjector::Move, kSpansAtOnce * kMostSamples> moves;
        std::size_t end = 0;
        for (const int span : spans.subspan(first, count)) {
            placeSpan(isKnown, span, spline);
            const std::size_t begin = (span * samplesPerSpan());
            for (std::size_t sample = begin; sample < begin + samplesPerSpan(); ++sample) {
                moves[end++] = {
                    spline.positions[sample], &spline.feet[sample], &spline.frames[sample]
                };
            }
        }
        facesSeen += finder.moveAll({moves.data(), end});
    });
    return facesSeen;
}

// Its samples' positions and second derivatives, with the feet that these predict.
void SampledIntegrals::placeSpan(bool isKnown, int span, FootedSpline& spline) const {
    const int count = space_.basisCount();
    const int perSpan = samplesPerSpan();
    const SpanControls controls = controlsOf(space_, spline.controls, span);
    for (int sample = span * perSpan; sample < (span + 1) * perSpan; ++sample) {
        const Sample& table = samples_[sample];
        Vec3 position = table.basis[0] * controls[0];
        Vec3 second = table.second[0] * controls[0];
        for (int j = 1; j < count; ++j) {
            position += table.basis[j] * controls[j];
            second += table.second[j] * controls[j];
        }
        if (isKnown) {
            FibreProjector::predict(
                position - spline.positions[sample], spline.frames[sample], spline.feet[sample]
            );
        }
        spline.positions[sample] = position;
        spline.seconds[sample] = second - table.fairedSecond;
    }
}

}  // namespace bspline_curve
