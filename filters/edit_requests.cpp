// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/edit_requests.h"

#include "filters/binding_makers.h"
#include "filters/requests.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

namespace {

constexpr std::string_view kBetween = ", \t";

std::vector<double> parametersOf(const std::string& text) {
    std::vector<double> parameters;
    std::string_view rest = text;
    const auto skipBetween = [&rest] {
        rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
    };
    for (skipBetween(); !rest.empty(); skipBetween()) {
        const std::string_view word = rest.substr(0, rest.find_first_of(kBetween));
        rest.remove_prefix(word.size());
        const std::optional<double> parameter = parseNumber(word);
        const bool isInside = parameter && *parameter >= 0.0 && *parameter <= 1.0;
        if (!isInside) {
            refuseChoice(
                "at is \"" + text +
                R"(", but must be parameters in [0, 1] with commas between them, as "0.25, 0.75")"
            );
        }
        parameters.push_back(*parameter);
    }
    return parameters;
}

}  // namespace

Bindings<EditRequest> editBindings() {
    using E = EditRequest;
    return {
        chosen(
            "edit",
            &E::edit,
            Names<CurveEdit>{
                {"join", CurveEdit::Join},
                {"split", CurveEdit::Split},
                {"trim", CurveEdit::Trim},
                {"extend", CurveEdit::Extend},
                {"reverse", CurveEdit::Reverse}
            }
        ),
        bound("at", &E::at),
        bound("extension", &E::extension),
        chosen(
            "ends",
            &E::ends,
            Names<CurveEnds>{
                {"end", CurveEnds::End}, {"start", CurveEnds::Start}, {"both", CurveEnds::Both}
            }
        ),
    };
}

Bindings<JoinOptions> joinBindings() {
    return {
        bound("smooth", &JoinOptions::isSmooth),
        boundLength("gap", &JoinOptions::gap),
        boundLength("blend", &JoinOptions::blend),
    };
}

EditRequest editRequest(const ParameterValues& values) {
    EditRequest request;
    request.use = curveUse(values);
    readAll(values, editBindings(), request);
    readAll(values, joinBindings(), request.join);
    request.join.validate();
    checkLength("extension", request.extension);
    const bool isCut = request.edit == CurveEdit::Split || request.edit == CurveEdit::Trim;
    if (isCut) {
        request.parameters = parametersOf(request.at);
        if (request.parameters.empty()) {
            refuseChoice(R"(at is empty, but must say where curves are cut, as "0.25, 0.75")");
        }
    }
    if (request.edit == CurveEdit::Trim && request.parameters.size() != 2) {
        refuseChoice(
            "at is \"" + request.at + R"(", but must be two parameters where edit is "trim")"
        );
    }
    return request;
}

}  // namespace bspline_curve
