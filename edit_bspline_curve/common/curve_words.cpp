// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/curve_words.h"

#include "bspline_curve/curve.h"
#include "filters/labels.h"
#include "text/error_messages.h"

#include <string>

namespace bspline_curve {
namespace {

QString lengthText(double length, const QString& unit) {
    return QString::number(length, 'g', 3) + (unit.isEmpty() ? QString() : " " + unit);
}

}  // namespace

QString countText(int count, const QString& noun) {
    return QString("%1 %2%3").arg(count).arg(noun, count == 1 ? "" : "s");
}

QString wordsFor(const SketchCurve& curve, double edge, const QString& unit) {
    const QString picks = countText(static_cast<int>(curve.picks.size()), "pick");
    if (!curve.problem.message.empty()) {
        // The panel has no such option.
        const std::string weld = "the filter \"" + curveFilter().name +
                                 "\" joins these components by the option weld (%)";
        const std::string words =
            withRemedy(curve.problem.message, curve.problem.remedy, {.mend = "", .weld = weld});
        return QString::fromStdString(withLabels(words, curveFilter()));
    }
    if (!curve.isDrawable()) {
        return QObject::tr("%1: click the next one").arg(picks);
    }
    if (curve.settled == nullptr) {
        return picks + " …";
    }
    const SolveReport& report = curve.settled->report;
    QString text =
        QObject::tr("%1, %2, %3 long.")
            .arg(
                picks,
                curve.options.solver.closed ? QObject::tr("closed") : QObject::tr("open"),
                lengthText(lengthOf(curve.settled->polyline), unit)
            );
    if (report.usable) {
        text += QObject::tr(" The line lies on the surface, its spline within %1 of it.")
                    .arg(lengthText(report.maxDistance * edge, unit));
    } else {
        text += QObject::tr(
                    " The line lies on the surface, but its spline is up to %1 away from it "
                    "(allowed: %2): add picks there."
        )
                    .arg(
                        lengthText(report.maxDistance * edge, unit),
                        lengthText(report.allowedDistance * edge, unit)
                    );
    }
    return text;
}

QString wordsForKind(const SketchCurve& curve, int pick) {
    if (pick < 0) {
        return {};
    }
    switch (kindOf(curve.picks[pick])) {
        case PickKind::Aligned:
            return QObject::tr(" Pick %1 has a direction: drag its handles.").arg(pick + 1);
        case PickKind::Corner:
            return QObject::tr(" Pick %1 is a corner.").arg(pick + 1);
        case PickKind::Free:
            return QObject::tr(" Pick %1 is a corner with two directions: drag its handles.")
                .arg(pick + 1);
        case PickKind::Automatic:
            break;
    }
    return {};
}

}  // namespace bspline_curve
