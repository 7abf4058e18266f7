// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/kept_font.h"

#include "filter_bspline_curve/common/window.h"

#include <QFileInfo>
#include <QSettings>

namespace bspline_curve {

namespace {

constexpr const char* kFontSetting = "bspline_curve/font";

}  // namespace

std::string keptFont() {
    if (!hasWindow()) {
        return {};
    }
    const QString file = QSettings().value(kFontSetting).toString();
    return QFileInfo(file).isFile() ? file.toStdString() : std::string();
}

void keepFont(const std::string& file) {
    if (hasWindow()) {
        // Relative to where MeshLab was started, which may differ the next time.
        const QString path = QString::fromStdString(file);
        QSettings().setValue(
            kFontSetting, file.empty() ? QString() : QFileInfo(path).absoluteFilePath()
        );
    }
}

}  // namespace bspline_curve
