// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/tool_icon.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace bspline_curve {

QIcon toolIcon() {
    constexpr int kSize = 64;
    QPixmap pixmap(kSize, kSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath path(QPointF(8, 50));
    path.cubicTo(16, 10, 26, 14, 32, 32);
    path.cubicTo(38, 50, 50, 54, 56, 14);
    painter.setPen(QPen(QColor(220, 50, 20), 5));
    painter.drawPath(path);
    painter.setPen(QPen(Qt::black, 2));
    painter.setBrush(Qt::white);
    for (const QPointF& pick : {QPointF(8, 50), QPointF(32, 32), QPointF(56, 14)}) {
        painter.drawEllipse(pick, 6, 6);
    }
    return {pixmap};
}

}  // namespace bspline_curve
