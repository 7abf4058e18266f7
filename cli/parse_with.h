// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"
#include "cli/verb.h"

#include <CLI/CLI.hpp>

#include <utility>
#include <variant>

namespace bspline_curve::cli {

/// What a parser, with parse(Arguments) and app(), makes of a command line; where that is wrong, or
/// asks for help, it is printed.
template <class Parser>
[[nodiscard]] std::variant<decltype(std::declval<Parser&>().parse({})), ExitCode> parseWith(
    Arguments arguments
) {
    Parser parser;
    try {
        return parser.parse(arguments);
    } catch (const CLI::ParseError& error) {
        return explainParseError(parser.app(), error);
    } catch (const InputError& error) {
        printError(error.what());
        return ExitCode::Usage;
    }
}

}  // namespace bspline_curve::cli
