#include "html_page.h"

#include <array>
#include <utility>

namespace mirrorball {

std::string htmlPage(const std::string& json)
{
    // "</script>" or "<!--" inside a script element would end it or change how it is read; in JSON < may be written \u003c.
    std::string safe;
    for (const char c : json) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    const PageParts parts = pageParts();
    const std::array<std::pair<std::string_view, std::string_view>, 5> places{{{"@STYLE@", parts.style},
                                                                               {"@CHART_LICENSE@", parts.chartLicense},
                                                                               {"@CHART_LIBRARY@", parts.chartLibrary},
                                                                               {"@REPORT@", safe},
                                                                               {"@SCRIPT@", parts.script}}};
    std::string page;
    std::string_view rest = parts.html;
    for (const auto& [place, text] : places) { // in the order of the template, so that no part is searched for places
        const size_t at = rest.find(place);
        page += rest.substr(0, at);
        page += text;
        rest.remove_prefix(at + place.size());
    }
    page += rest;
    return page;
}

} // namespace mirrorball
