// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/kept_settings.h"

#include <QColor>
#include <QSettings>

namespace bspline_curve::kept {

namespace {

QString keyOf(const QString& name) {
    return "bspline_curve/" + name;
}

}  // namespace

QVariant value(const QString& name, const QVariant& standard) {
    return QSettings().value(keyOf(name), standard);
}

void setValue(const QString& name, const QVariant& value) {
    QSettings settings;
    if (settings.value(keyOf(name)) != value) {  // else the window waits for the disk for nothing
        settings.setValue(keyOf(name), value);
    }
}

SketchColour colour() {
    const QColor kept(value("colour").toString());
    if (!kept.isValid()) {
        return {};
    }
    return {
        static_cast<std::uint8_t>(kept.red()),
        static_cast<std::uint8_t>(kept.green()),
        static_cast<std::uint8_t>(kept.blue())
    };
}

void setColour(SketchColour colour) {
    setValue("colour", QColor(colour.red, colour.green, colour.blue).name());
}

QString unit() {
    return value("unit").toString();
}

void setUnit(const QString& unit) {
    setValue("unit", unit);
}

bool isMagnetOn() {
    return value("magnet", false).toBool();
}

void setMagnetOn(bool isOn) {
    setValue("magnet", isOn);
}

QString folder() {
    return value("folder").toString();
}

void setFolder(const QString& folder) {
    setValue("folder", folder);
}

}  // namespace bspline_curve::kept
