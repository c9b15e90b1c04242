#pragma once

#include "core/filter/method.h"
#include "core/filter/prefilter.h"

#include <string>
#include <vector>

namespace mirrorball {

/// One point of a method's knobs: what a report measures.
struct MethodSetting {
    Method method = Method::Auto;
    double tolerance = 1e-5; ///< the knob of methods that have no other
    MethodKnobs knobs{};
    std::string label{}; ///< "tolerance 1e-3", "1024 samples", "lambda by width per-face"; empty: the method has no knob

    /// The options of prefilter().
    PrefilterOptions options(const Lobe& lobe, const MapLayout& target) const;
};

/// How many points a knob gets.
enum class Sweep { Few, Usual };

/// The settings of a method from cheap to dear: tolerances 1e-2 to 1e-6 and `tolerance` among them, samples 16 to 65536, both
/// filterings of the mip method, clamps and kernels of the paraboloids; one where there is no knob.
std::vector<MethodSetting> methodSettings(Method method, Sweep sweep, double tolerance);

/// The words of `mirrorball filter` that make this map: "mirrorball filter 'p.hdr' -o map.exr --lobe phong --exponent 50 --to cube
/// --size 64 --method importance --samples 1024". Empty for a lobe that the command line cannot spell.
std::string filterCommand(const std::string& probe, const PrefilterOptions& options);

/// A number in as many digits as it takes to be read back the same: "0.1", "50".
std::string exactNumber(double value);

/// A figure in few digits, as words want it: "1e-3", "0.25", "1.5e7".
std::string shortNumber(double value, int digits = 3);

} // namespace mirrorball
