// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/field_on_surface.h"

#include "bspline_curve/error.h"

#include <string>
#include <utility>

namespace bspline_curve {

ScalarField fieldOf(const Surface& surface, std::vector<double> values) {
    const Provenance& provenance = surface.provenance();
    if (provenance.isIdentity()) {
        return values;
    }
    auto own = std::make_shared<const ScalarField::OnSurface>(
        ScalarField::OnSurface{.surface = provenance.key(), .values = values}
    );
    return {provenance.valuesOfInput(std::move(values)), std::move(own)};
}

std::shared_ptr<const std::vector<double>> valuesOn(
    const Surface& surface, const ScalarField& field
) {
    if (field.empty()) {
        return nullptr;
    }
    const std::size_t vertices = surface.input().vertices.size();
    if (field.values().size() != vertices) {
        throw InputError(
            InputErrorCode::BadField,
            "the field has " + std::to_string(field.values().size()) + " values for " +
                std::to_string(vertices) + " vertices: give one value per vertex"
        );
    }
    const Provenance& provenance = surface.provenance();
    if (provenance.isIdentity()) {
        return field.shared();
    }
    const auto& own = field.onSurface();
    if (own != nullptr && own->surface == provenance.key()) {
        return {own, &own->values};
    }
    return std::make_shared<const std::vector<double>>(provenance.valuesFromInput(field.values()));
}

}  // namespace bspline_curve
