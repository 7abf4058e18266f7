// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/error_messages.h"
#include "web/core/calls.h"

#include <exception>
#include <new>
#include <utility>

namespace bspline_curve::web {

namespace {

constexpr RemedyWords kRemedyWords{
    .mend = "without the option strict the mesh is mended",
    .weld = "opened with the option weld of %, its components are joined"
};

Json errorJson(std::string code, std::string message) {
    return {
        {"code", std::move(code)}, {"message", std::move(message)}, {"elements", Json::array()}
    };
}

}  // namespace

std::string messageOf(const std::string& message, const Remedy& remedy) {
    return withRemedy(message, remedy, kRemedyWords);
}

Json currentError() {
    try {
        throw;
    } catch (const InputError& error) {
        Json json = errorJson(name(error.code()), messageOf(error.what(), error.remedy()));
        json["elements"] = error.elements();
        return json;
    } catch (const Cancelled&) {
        return errorJson("cancelled", "cancelled");
    } catch (const std::bad_alloc&) {
        return errorJson("memory", "there is not enough memory for this");
    } catch (const std::exception& error) {
        return errorJson("internal", error.what());
    }
}

}  // namespace bspline_curve::web
