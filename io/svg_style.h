// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/xml_tree.h"

#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

/// The style sheets of an SVG file (CSS 2, Sect. 5 and 6): rules whose selectors are a name, a
/// class, an id, or these together as in "g.hidden"; all others are passed over.
class SvgStyles {
public:
    /// Collects the rules of all elements <style>.
    explicit SvgStyles(const XmlElement& root);

    /// The value of a property of an element: in its attribute `style`, else of the rule that
    /// selects it most closely, else in the attribute of that name; empty: none of these.
    [[nodiscard]] std::string_view valueOf(
        const XmlElement& element, std::string_view property
    ) const;

private:
    struct Rule {
        std::string name, id, className;  // empty: any
        std::string declarations;

        [[nodiscard]] bool selects(const XmlElement& element) const;
        [[nodiscard]] int closeness() const;
    };

    void collect(const XmlElement& element);
    void addRules(std::string_view text);
    void addSelector(std::string_view selector, std::string_view declarations);

    std::vector<Rule> rules_;
};

}  // namespace bspline_curve
