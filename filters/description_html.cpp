// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/description_html.h"

namespace bspline_curve {

namespace {

std::string escaped(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        default:
            return {c};
    }
}

std::string htmlOf(const std::string& markdown) {
    std::string html;
    bool isInside = false;
    for (std::size_t i = 0; i < markdown.size(); ++i) {
        const char c = markdown[i];
        if (c == '*' || c == '`') {
            isInside = !isInside;
            html += isInside ? "<i>" : "</i>";
        } else if (c == '\n') {
            html += "<br>";
            i += i + 1 < markdown.size() && markdown[i + 1] == '\n' ? 1 : 0;
        } else {
            html += escaped(c);
        }
    }
    return html;
}

}  // namespace

std::string descriptionHtml(const FilterDescription& filter) {
    std::string html = htmlOf(filter.longDescriptionMarkdown);
    for (const Publication& publication : filter.publications) {
        html += "<br>See:<br><a href=\"" + publication.url + "\"><b>\"" + publication.title +
                "\"</b></a><br>" + publication.container + ", " + std::to_string(publication.year) +
                ".";
    }
    return html;
}

}  // namespace bspline_curve
