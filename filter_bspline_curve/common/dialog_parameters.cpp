// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/dialog_parameters.h"

#include "filter_bspline_curve/common/kept_font.h"
#include "filter_bspline_curve/common/surface_choice.h"
#include "filter_bspline_curve/common/window.h"

#include <QStringList>
#include <array>
#include <charconv>
#include <stdexcept>
#include <string>
#include <variant>

namespace bspline_curve {

namespace {

/// Radius of the tube of a curve in a window, relative to the diagonal of the surface: about two
/// pixels wide where the whole surface is in view.
constexpr double kTubeInWindows = 0.0015;

QString textOf(const std::string& text) {
    return QString::fromStdString(text);
}

// ---- from the description to the dialog ----

/// "*.pp", …: the patterns of Qt's file dialogs.
QStringList patternsOf(const ParameterDescription& parameter) {
    QStringList patterns;
    for (const std::string& extension : parameter.extensions) {
        patterns << "*" + textOf(extension);
    }
    return patterns;
}

QStringList optionsOf(const ParameterDescription& parameter) {
    QStringList options;
    for (const EnumOption& option : parameter.options) {
        options << textOf(option.id);
    }
    return options;
}

/// Adds the parameters of a filter to a list, one after the other.
class DialogBuilder {
public:
    DialogBuilder(RichParameterList& list, host::DialogDocument& document)
        : list_(list), document_(document), surface_(defaultSurface(document)) {}

    void add(const ParameterDescription& p) {
        switch (p.type) {
            case ParameterType::Layer:
                host::addLayer(
                    list_,
                    textOf(p.id),
                    textOf(p.label),
                    textOf(p.fullHelp()),
                    p.isFolded(),
                    p.id == "curve_layer" ? defaultCurves(document_) : surface_,
                    document_
                );
                break;
            case ParameterType::Bool:
                addAs<RichBool>(
                    p, (p.isOnInWindow && hasWindow()) || std::get<bool>(p.defaultValue)
                );
                break;
            case ParameterType::Int:
                addAs<RichInt>(p, std::get<int>(p.defaultValue));
                break;
            case ParameterType::Double:
                addNumber(p);
                break;
            case ParameterType::Percentage:
                addAs<host::Percentage>(p, defaultLength(p), Scalarm(0), diagonal());
                break;
            case ParameterType::Enum:
                addAs<RichEnum>(p, static_cast<int>(p.defaultOption()), optionsOf(p));
                break;
            case ParameterType::Length:
            case ParameterType::Tolerances:
            case ParameterType::Picks:
            case ParameterType::Tangents:
            case ParameterType::Text:
                addAs<RichString>(p, defaultText(p));
                break;
            case ParameterType::OpenFile:
            case ParameterType::SaveFile:
                addFile(p);
                break;
        }
    }

private:
    template <class Rich, class... Values>
    void addAs(const ParameterDescription& p, Values&&... values) {
        host::add<Rich>(
            list_,
            textOf(p.id),
            textOf(p.label),
            textOf(p.fullHelp()),
            p.isFolded(),
            std::forward<Values>(values)...
        );
    }

    void addNumber(const ParameterDescription& p) {
        const auto standard = static_cast<Scalarm>(std::get<double>(p.defaultValue));
        if (p.isSlider && p.min && p.max) {
            const auto least = static_cast<Scalarm>(*p.min);
            const auto most = static_cast<Scalarm>(*p.max);
            addAs<RichDynamicFloat>(p, standard, least, most);
        } else {
            addAs<RichFloat>(p, standard);
        }
    }

    void addFile(const ParameterDescription& p) {
        if (!host::kFileWidgetsTakeTyping && hasWindow()) {
            addAs<RichString>(p, defaultText(p));
        } else if (p.type == ParameterType::OpenFile) {
            addAs<host::FileOpen>(p, defaultText(p), patternsOf(p));
        } else {
            addAs<host::FileSave>(p, defaultText(p), patternsOf(p).join(" "));
        }
    }

    static QString defaultText(const ParameterDescription& p) {
        return textOf(p.id == "font" ? keptFont() : std::get<std::string>(p.defaultValue));
    }

    /// In the unit of the mesh.
    [[nodiscard]] Scalarm defaultLength(const ParameterDescription& p) const {
        return p.id == "tube_radius" && hasWindow()
                   ? static_cast<Scalarm>(kTubeInWindows) * diagonal()
                   : static_cast<Scalarm>(std::get<double>(p.defaultValue));
    }

    [[nodiscard]] Scalarm diagonal() const {
        return surface_ == nullptr || surface_->cm.VN() == 0 ? Scalarm(1)
                                                             : surface_->cm.trBB().Diag();
    }

    RichParameterList& list_;
    host::DialogDocument& document_;
    const MeshModel* surface_;
};

bool isOffered(const ParameterDescription& parameter, Offered offered) {
    if (parameter.isOfWindow() && !hasWindow()) {
        return false;
    }
    switch (offered) {
        case Offered::Main:
            return !parameter.isFolded();
        case Offered::Usual:
            return !parameter.isAdvanced() && !parameter.isOfWindow();
        case Offered::All:
            break;
    }
    return true;
}

// ---- from the dialog to values ----

/// MeshLab keeps a parameter as float even where its scalar is double, so 0.1 arrives as
/// 0.10000000149. The number that the user typed is the shortest decimal that rounds to that float.
double typedNumber(Scalarm value) {
    std::array<char, 32> digits{};
    const char* const end =
        std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(value)).ptr;
    double number = 0.0;
    std::from_chars(digits.data(), end, number);
    return number;
}

std::string trimmedText(const QString& text) {
    return text.trimmed().toStdString();
}

void setNumber(RichParameterList& list, const ParameterDescription& p, float number) {
    const QString name = textOf(p.id);
    if (p.type == ParameterType::Percentage) {
        list.setValue(name, host::PercentageNumber(number));
    } else if (p.isSlider) {
        list.setValue(name, host::SliderNumber(number));
    } else {
        list.setValue(name, FloatValue(number));
    }
}

void read(const RichParameterList& list, const ParameterDescription& p, ParameterValues& values) {
    const QString name = textOf(p.id);
    switch (p.type) {
        case ParameterType::Layer:
            values.set(p.id, host::layerOf(list, name));
            break;
        case ParameterType::Bool:
            values.set(p.id, list.getBool(name));
            break;
        case ParameterType::Int:
            values.set(p.id, list.getInt(name));
            break;
        case ParameterType::Double:
            values.set(
                p.id, typedNumber(p.isSlider ? list.getDynamicFloat(name) : list.getFloat(name))
            );
            break;
        case ParameterType::Percentage:
            values.set(p.id, typedNumber(list.getAbsPerc(name)));
            break;
        case ParameterType::Enum:
            values.setOption(p.id, list.getEnum(name));
            break;
        case ParameterType::Length:
        case ParameterType::Tolerances:
        case ParameterType::Picks:
        case ParameterType::Tangents:
        case ParameterType::Text:
            values.set(p.id, trimmedText(list.getString(name)));
            break;
        case ParameterType::OpenFile:
        case ParameterType::SaveFile:
            values.set(p.id, trimmedText(host::pathOf(list, name)));
            break;
    }
}

}  // namespace

RichParameterList dialogParameters(
    const FilterDescription& filter, host::DialogDocument& document, Offered offered
) {
    RichParameterList list;
    DialogBuilder builder(list, document);
    for (const ParameterDescription& parameter : filter.parameters) {
        if (isOffered(parameter, offered)) {
            builder.add(parameter);
        }
    }
    return list;
}

void setParameter(
    RichParameterList& list,
    const ParameterDescription& parameter,
    const ParameterValue& value,
    MeshDocument& document
) {
    const QString name = textOf(parameter.id);
    if (const auto* const flag = std::get_if<bool>(&value)) {
        list.setValue(name, BoolValue(*flag));
    } else if (const auto* const count = std::get_if<int>(&value)) {
        list.setValue(name, IntValue(*count));
    } else if (const auto* const number = std::get_if<double>(&value)) {
        setNumber(list, parameter, static_cast<float>(*number));
    } else if (const auto* const layer = std::get_if<LayerId>(&value)) {
        list.setValue(name, host::layerValue(document, layer->id));
    } else if (parameter.type == ParameterType::Enum) {
        const auto option = parameter.indexOf(std::get<std::string>(value));
        if (!option) {
            throw std::out_of_range(parameter.id + " has no such option");
        }
        list.setValue(name, host::EnumNumber(static_cast<int>(*option)));
    } else {
        list.setValue(name, StringValue(textOf(std::get<std::string>(value))));
    }
}

ParameterValues valuesOf(const RichParameterList& list, const FilterDescription& filter) {
    ParameterValues values(filter);
    for (const ParameterDescription& parameter : filter.parameters) {
        if (list.hasParameter(textOf(parameter.id))) {
            read(list, parameter, values);
        }
    }
    return values;
}

}  // namespace bspline_curve
