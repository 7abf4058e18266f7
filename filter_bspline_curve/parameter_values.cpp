// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/parameter_values.h"

#include <common/mlexception.h>

#include <array>
#include <charconv>

namespace bspline_curve {

int choiceOf(const RichParameterList& parameters, const QString& name, const QStringList& choices) {
    const int choice = parameters.getEnum(name);
    if (choice < 0 || choice >= choices.size()) {
        throw MLException(QString("%1 must be one of: %2").arg(name, choices.join(", ")));
    }
    return choice;
}

double typedNumber(Scalarm value) {
    std::array<char, 32> digits{};
    const char* const end =
        std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(value)).ptr;
    double number = 0.0;
    std::from_chars(digits.data(), end, number);
    return number;
}

}  // namespace bspline_curve
