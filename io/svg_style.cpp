// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg_style.h"

#include "text/text_parsing.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ranges>
#include <utility>

namespace bspline_curve {

namespace {

/// How closely selectors select: an id more than a class, a class more than a name.
constexpr int kId = 100;
constexpr int kClass = 10;

/// The value of a property in "a: b; c: d"; empty: it is not there.
std::string_view declared(std::string_view declarations, std::string_view property) {
    std::string_view value;
    for (const std::string_view part : splitAt(declarations, ';')) {
        const std::size_t colon = part.find(':');
        if (colon != std::string_view::npos && trimmed(part.substr(0, colon)) == property) {
            value = trimmed(part.substr(colon + 1));
            constexpr std::string_view kImportant = "!important";
            if (value.ends_with(kImportant)) {
                value = trimmed(value.substr(0, value.size() - kImportant.size()));
            }
        }
    }
    return value;
}

std::string withoutComments(std::string_view text) {
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t start = std::min(text.find("/*", at), text.size());
        plain += text.substr(at, start - at);
        const std::size_t end = text.find("*/", start);
        at = end == std::string_view::npos ? text.size() : end + 2;
    }
    return plain;
}

}  // namespace

SvgStyles::SvgStyles(const XmlElement& root) {
    collect(root);
    // Of rules that select an element as closely, the last one counts.
    std::vector<Rule> sorted;
    for (const int closeness :
         {0, 1, kClass, kClass + 1, kId, kId + 1, kId + kClass, kId + kClass + 1}) {
        std::ranges::copy_if(rules_, std::back_inserter(sorted), [&](const Rule& rule) {
            return rule.closeness() == closeness;
        });
    }
    rules_ = std::move(sorted);
}

std::string_view SvgStyles::valueOf(const XmlElement& element, std::string_view property) const {
    if (const std::string_view own = declared(element.attribute("style"), property); !own.empty()) {
        return own;
    }
    for (const Rule& rule : std::views::reverse(rules_)) {
        if (rule.selects(element)) {
            const std::string_view value = declared(rule.declarations, property);
            if (!value.empty()) {
                return value;
            }
        }
    }
    return trimmed(element.attribute(property));
}

bool SvgStyles::Rule::selects(const XmlElement& element) const {
    if ((!name.empty() && name != element.name) ||
        (!id.empty() && id != trimmed(element.attribute("id")))) {
        return false;
    }
    const std::vector<std::string_view> classes = splitAtBlanks(element.attribute("class"));
    return className.empty() || std::ranges::find(classes, className) != classes.end();
}

int SvgStyles::Rule::closeness() const {
    return (id.empty() ? 0 : kId) + (className.empty() ? 0 : kClass) + (name.empty() ? 0 : 1);
}

void SvgStyles::collect(const XmlElement& element) {
    if (element.name == "style") {
        addRules(withoutComments(element.text));
    }
    for (const XmlElement& child : element.children) {
        collect(child);
    }
}

void SvgStyles::addRules(std::string_view text) {
    for (std::size_t at = 0;;) {
        const std::size_t open = text.find('{', at);
        const std::size_t close = text.find('}', std::min(open, text.size()));
        if (close == std::string_view::npos) {
            return;
        }
        for (const std::string_view selector : splitAt(text.substr(at, open - at), ',')) {
            addSelector(selector, text.substr(open + 1, close - open - 1));
        }
        at = close + 1;
    }
}

void SvgStyles::addSelector(std::string_view selector, std::string_view declarations) {
    if (selector.find_first_of(" \t\r\n>+~:[@") != std::string_view::npos) {
        return;
    }
    Rule rule{.name = {}, .id = {}, .className = {}, .declarations = std::string(declarations)};
    std::string* part = &rule.name;
    for (const char c : selector) {
        if (c == '.' || c == '#') {
            part = c == '.' ? &rule.className : &rule.id;
            if (!part->empty()) {
                return;  // two classes
            }
        } else if (c != '*') {
            *part += c;
        }
    }
    rules_.push_back(std::move(rule));
}

}  // namespace bspline_curve
