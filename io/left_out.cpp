// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/left_out.h"

#include <string_view>

namespace bspline_curve {

void LeftOut::add(std::size_t line, const std::string& reason) {
    if (count_++ == 0) {
        first_ = "line " + std::to_string(line) + ": " + reason;
    }
}

void LeftOut::add(const InputError& error) {
    if (count_++ == 0) {
        const std::string_view message = error.what();
        const std::string start = file_.string() + ", ";
        first_ = message.starts_with(start) ? message.substr(start.size()) : message;
    }
}

std::string LeftOut::note(const std::string& one, const std::string& many) const {
    const std::string start = file_.filename().string() + ": ";
    return count_ == 1
               ? start + "1 " + one + " left out; " + first_
               : start + std::to_string(count_) + " " + many + " left out; the first, " + first_;
}

void LeftOut::refuse() const {
    throw InputError(InputErrorCode::UnreadableFile, file_.string() + ", " + first_);
}

}  // namespace bspline_curve
