#pragma once

#include "prefilter.h"

#include "core/image/probe_file.h"

#include <span>
#include <string>
#include <vector>

namespace mirrorball {

/// A probe opened for filtering, whole or as a stream.
struct OpenedSource {
    FilterSource source;
    RepairReport repaired{};
    std::string origin{}; ///< how the parameterization was found, in words
    bool streamed = false;
    std::vector<Stage> stages{};      ///< what opening it took
    std::vector<std::string> notes{}; ///< what of the file a user should know
};

/// Probes of more texels than this are streamed where the lobes allow it (33 million: 400 MB as floats).
inline constexpr std::int64_t streamedFrom = std::int64_t{1} << 25;

/// How far the rows of a streamed probe are followed for a filter: as its lobe asks for whatever the probe holds, and of a smooth lobe,
/// whose spectrum ends soon, until the tolerance is kept where the map is a thousandth of its mean, too. What turns out not to be enough is
/// refused.
int streamedBandLimit(const PrefilterOptions& filter);

/// Makes a probe ready for the given filter jobs. A latlong file of more than streamedFrom texels is never held: its rows go through a
/// SpectrumBuilder at the band limit that the jobs need, which is exact, in little memory; its brightest texels are remembered, to be
/// taken out of the rows again where the promise needs it. That asks for lobes which are resolved and
/// for the method spectral or auto; otherwise, and for other probes, it is read whole.
/// @throws FileError, InvalidArgument, Cancelled
OpenedSource openFilterSource(ProbeFile& probe, std::span<const PrefilterOptions> jobs, const JobControl& job);

} // namespace mirrorball
