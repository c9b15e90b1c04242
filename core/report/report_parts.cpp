#include "report_parts.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 7> partWords{"methods", "parameterizations", "growth",    "stability",
                                                    "kernels", "distortion",        "comparison"};

} // namespace

std::span<const std::string_view> words(ReportPart) { return partWords; }

bool needsProbe(ReportPart part) { return part != ReportPart::Stability && part != ReportPart::Distortion; }

std::vector<ReportPart> reportPartsFromWords(std::string_view words)
{
    std::vector<ReportPart> parts;
    for (size_t first = 0; first <= words.size();) {
        const size_t end = std::min(words.find(',', first), words.size());
        const std::string_view word = words.substr(first, end - first);
        const auto found = std::find(partWords.begin(), partWords.end(), word);
        if (found == partWords.end()) {
            std::string known;
            for (const std::string_view part : partWords)
                known += (known.empty() ? "" : ", ") + std::string(part);
            throw InvalidArgument("'" + std::string(word) + "' is no part of a report; choose among " + known);
        }
        parts.push_back(static_cast<ReportPart>(found - partWords.begin()));
        first = end + 1;
    }
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    return parts;
}

} // namespace mirrorball
