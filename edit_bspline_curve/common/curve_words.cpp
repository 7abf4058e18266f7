// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/curve_words.h"

#include "design/strict_polyline.h"

namespace bspline_curve {
namespace {

QString lengthText(double length, const QString& unit) {
    return QString::number(length, 'g', 3) + (unit.isEmpty() ? QString() : " " + unit);
}

QString countOfPicks(const SketchCurve& curve) {
    const auto picks = static_cast<int>(curve.picks.size());
    return picks == 1 ? QObject::tr("1 pick") : QObject::tr("%1 picks").arg(picks);
}

}  // namespace

QString wordsFor(const SketchCurve& curve, double edge, const QString& unit) {
    if (!curve.problem.message.empty()) {
        return QString::fromStdString(curve.problem.message);
    }
    if (!curve.isDrawable()) {
        return countOfPicks(curve) + QObject::tr(": click the next one");
    }
    if (curve.settled == nullptr) {
        return countOfPicks(curve) + " …";
    }
    const SolveReport& report = curve.settled->report;
    QString text =
        QObject::tr("%1, %2, %3 long.")
            .arg(
                countOfPicks(curve),
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

}  // namespace bspline_curve
