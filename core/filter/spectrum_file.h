#pragma once

#include "bright_texels.h"
#include "filter_source.h"
#include "source_file.h"
#include "spectrum.h"

#include "core/base/job.h"
#include "core/image/probe_file.h"
#include "core/image/repair.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Spectra as files: what a probe too large for one machine is brought to, some of its rows at a time. Spectra add up, so that parts made
/// on many machines are the whole probe's in the end, and what filters it needs no more than that.
namespace mirrorball {

/// The spectrum of some rows of a latlong probe, without what was taken out of its brightest texels.
struct SpectrumPart {
    Spectrum calm{};              ///< of the rows that are there; others count as black
    BrightTexels bright{};        ///< what was taken out, in the order of rows
    double threshold = 0.0;       ///< largest channel of a texel that stays as it is; 0: nothing was taken out
    std::vector<RowRange> rows{}; ///< that are there, in order, apart from one another
    RepairReport repaired{};
    std::string probe{}; ///< its name, for messages

    /// Whether every row is there.
    bool isWhole() const { return rows.size() == 1 && rows.front() == RowRange{0, calm.rings}; }
};

struct SpectrumOptions {
    int degree = 256;       ///< band limit, 1 to largestBandLimit: lobes are filtered as far as it holds them
    double threshold = 0.0; ///< SpectrumPart::threshold
    std::optional<RowRange> rows{};
};

/// Reads rows of a probe and transforms them. Of a format that is read from its top the rows above are read and thrown away. Memory: 48
/// (degree + 1) bytes a row of the part, and some rows as they are.
/// @throws InvalidArgument unless the probe is a latlong file, or for rows that it has not; FileError; Cancelled
SpectrumPart probeSpectrum(ProbeFile& probe, const SpectrumOptions& options, const JobControl& job = {});

/// The sum of parts. What comes of it does not depend on their order.
/// @throws InvalidArgument for parts that do not belong together, naming what differs, or that share rows
SpectrumPart addSpectra(std::vector<SpectrumPart> parts);

/// One file: a line that names the format, a line of JSON, and the numbers as little-endian doubles. It appears whole or not at all.
void writeSpectrum(const std::filesystem::path& path, const SpectrumPart& part);
/// @throws InvalidArgument for the name of a picture, by which isSpectrumFile() would not know it
void checkSpectrumName(const std::filesystem::path& path);
/// Whether a file begins as such a file does. False where it cannot be read, and for the name of a picture, which is not opened for it.
bool isSpectrumFile(const std::filesystem::path& path);
/// @throws FileError for a file that is damaged or longer or shorter than it says
SpectrumPart readSpectrum(const std::filesystem::path& path);

/// A whole spectrum made ready for filtering: what was taken out is added as the promise of a tolerance needs it.
/// @throws InvalidArgument when rows are missing, naming the first of them
FilterSource filterSource(SpectrumPart whole, const JobControl& job = {});

/// The file of a whole spectrum, opened for filtering. @throws as readSpectrum() and filterSource()
OpenedSource openSpectrum(const std::filesystem::path& path, const JobControl& job = {});

} // namespace mirrorball
