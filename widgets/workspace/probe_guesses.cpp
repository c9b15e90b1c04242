#include "probe_guesses.h"

#include "widgets/controls/images.h"
#include "widgets/controls/text.h"

#include "core/image/color.h"
#include "core/image/map_file.h"
#include "core/image/reproject.h"

#include <QCoreApplication>

#include <algorithm>
#include <tuple>

namespace mirrorball::studio {

namespace {

ProbeGuess guessOf(const ReducedProbe& probe, double exposure, const ProbeReading& reading, const JobControl& job)
{
    constexpr int height = 64;
    EnvironmentMap map;
    if (reading.fit == Fit::Crop) {
        ImageFileInfo small = probe.info;
        small.width = probe.image.width;
        small.height = probe.image.height;
        map = reproject(toEnvironmentMap(probe.image, detectLayout(small, reading), job),
                        {.target = {Parameterization::Latlong, height, 0}}, job);
    } else {
        map = thumbnailOf(probe, height, reading.parameterization, job);
    }
    return {*reading.parameterization, reading.fit, toQImage(toDisplay(map.image, std::clamp(exposure, -14.0, 14.0), ToneCurve::Filmic))};
}

} // namespace

std::vector<ProbeGuess> probeGuesses(const ReducedProbe& probe, double exposure, const JobControl& job)
{
    std::vector<ProbeGuess> guesses;
    const bool isBall = probe.detection.arrangement == Arrangement::Ball; // which is offered as such below
    for (const Parameterization kind : possibleKinds(probe))
        if (!isBall || kind != Parameterization::Sphere)
            guesses.push_back(guessOf(probe, exposure, {.parameterization = kind}, job));
    if (probe.info.sampleType.starts_with("uint"))
        guesses.push_back(guessOf(probe, exposure, {.parameterization = Parameterization::Sphere, .fit = Fit::Crop}, job));
    std::sort(guesses.begin(), guesses.end(),
              [](const ProbeGuess& a, const ProbeGuess& b) { return std::tie(a.fit, a.kind) < std::tie(b.fit, b.kind); });
    return guesses;
}

QString guessText(const ProbeGuess& guess)
{
    return guess.fit == Fit::Crop ? QCoreApplication::translate("ProbeGuesses", "mirror ball") : fieldText(name(guess.kind));
}

} // namespace mirrorball::studio
