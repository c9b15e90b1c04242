#pragma once

#include "core/base/job.h"
#include "core/image/thumbnail.h"

#include <QImage>
#include <QString>

#include <vector>

namespace mirrorball::studio {

/// What a file may be that does not say it.
struct ProbeGuess {
    Parameterization kind;
    Fit fit = Fit::None; ///< Crop: a mirror ball somewhere in a photograph
    QImage picture{};    ///< the environment that it would be, as a small latlong
};

/// A picture of each parameterization that the shape of a probe fits, and for a photograph of the mirror ball in it.
/// @param exposure  of the pictures, in stops
/// @throws FileError, Cancelled
std::vector<ProbeGuess> probeGuesses(const ReducedProbe& probe, double exposure, const JobControl& job);

/// "angular", "mirror ball", in the user's language.
QString guessText(const ProbeGuess& guess);

} // namespace mirrorball::studio
