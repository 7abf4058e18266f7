// SPDX-License-Identifier: GPL-3.0-or-later
// What the module exports and imports: JSON in, JSON out, and memory for arrays.
#include "bspline_curve/progress.h"
#include "web/core/calls.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace bspline_curve::web {

namespace {

// The page's: how far a call is, as a share of [0, 1], and the name of its stage. 0: give it up.
extern "C" __attribute__((import_module("host"), import_name("progress"))) int hostTold(
    double fraction, const char* stage, std::size_t length
);

struct Answer {
    Reply arrays;
    std::string text;
};

Answer& answer() {
    static Answer last;
    return last;
}

Call callOf(const std::string& name) {
    for (const Calls* calls : {&meshCalls(), &curveCalls(), &useCalls(), &sessionCalls()}) {
        if (const auto place = calls->find(name); place != calls->end()) {
            return place->second;
        }
    }
    throw std::invalid_argument("there is no call " + name);
}

// Bytes that are no UTF-8 stand in names of files that a message repeats.
std::string textOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Progress hostProgress() {
    return [](double fraction, const char* stage) {
        return hostTold(fraction, stage, std::strlen(stage)) != 0;
    };
}

extern "C" {

/// Memory for what a call is given; null where there is none.
__attribute__((export_name("bc_alloc"))) void* allocateForPage(std::size_t bytes) {
    return std::malloc(bytes);  // NOLINT(cppcoreguidelines-no-malloc): the page has no types
}

__attribute__((export_name("bc_free"))) void freeForPage(void* memory) {
    std::free(memory);  // NOLINT(cppcoreguidelines-no-malloc)
}

/// Carries out {"call": name, …}. Whether it could; the answer, or {"code", "message", "elements"},
/// is at bc_answer() until the next call.
__attribute__((export_name("bc_call"))) int call(const char* text, std::size_t length) {
    Answer& last = answer();
    last = {};
    try {
        const Json arguments = Json::parse(text, text + length);
        const Json result = callOf(arguments.at("call").get<std::string>())(arguments, last.arrays);
        last.text = textOf(result);
        return 1;
    } catch (...) {
        last.arrays = {};
        last.text = textOf(currentError());
        return 0;
    }
}

__attribute__((export_name("bc_answer"))) const char* answerText() {
    return answer().text.data();
}

__attribute__((export_name("bc_answer_size"))) std::size_t answerSize() {
    return answer().text.size();
}

}  // extern "C"

}  // namespace bspline_curve::web
