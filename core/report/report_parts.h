#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball {

/// What a report can hold, each measured by itself.
enum class ReportPart {
    Methods,           ///< error against run time of every method, on every probe with every lobe
    Parameterizations, ///< the parameterizations at equal texel counts, on the first probe
    Growth,            ///< how cost grows with the probe and the exponent
    Stability,         ///< the extreme cases
    Kernels,           ///< the table of kernel sizes of 000 section 3.2.5, with frames a second
    Distortion,        ///< 000 figure 12
    Comparison         ///< 000 figure 13, on the first probe
};
std::span<const std::string_view> words(ReportPart); // methods parameterizations growth stability kernels distortion comparison

/// Whether it looks at a probe of the user's.
bool needsProbe(ReportPart part);

/// "methods,growth": each once, in the order of the enumeration.
/// @throws InvalidArgument for a word that is none, naming those there are
std::vector<ReportPart> reportPartsFromWords(std::string_view words);

} // namespace mirrorball
