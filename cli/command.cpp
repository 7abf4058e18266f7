// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <exception>
#include <new>
#include <string>

namespace bspline_curve::cli {

ExitCode reportingErrors(const std::function<ExitCode()>& run) {
    try {
        return run();
    } catch (const std::bad_alloc&) {
        printError("out of memory");
    } catch (const std::exception& error) {
        printError(std::string("internal error: ") + error.what());
    }
    return ExitCode::Failure;
}

}  // namespace bspline_curve::cli
