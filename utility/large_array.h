// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace bspline_curve {

/// Asks the system for large pages of memory for a range that nothing has been written to yet. A
/// hint that systems may ignore.
void preferLargePages(void* begin, std::size_t bytes);

/// Reserves room for so many elements, in large pages of memory where they fill several: what many
/// faces take is then read at random faster: further curves at 1.8 million faces by 5 %.
template <class Element>
void reserveLarge(std::vector<Element>& elements, std::size_t count) {
    if (count > elements.capacity()) {
        elements.reserve(count);
        Element* const unused = elements.data() + elements.size();
        preferLargePages(unused, (elements.capacity() - elements.size()) * sizeof(Element));
    }
}

/// A vector of so many equal elements with room reserved in that way.
template <class Element>
[[nodiscard]] std::vector<Element> makeLarge(std::size_t count, const Element& value) {
    std::vector<Element> elements;
    reserveLarge(elements, count);
    elements.assign(count, value);
    return elements;
}

}  // namespace bspline_curve
