#pragma once

#include "core/base/job.h"

#include <functional>
#include <string>
#include <vector>

/// The extreme cases of shading - Fresnel terms, lambda, the sphere map's rim, painted maps - and what must hold in them. Each family is
/// judged against a formula of its own, in another form and in more digits than the code it judges.
namespace mirrorball {

/// One extreme case: what the code gives at many places, beside what it must give there.
struct ShadingCase {
    std::string family{}; ///< "Fresnel, dielectric"
    std::string name{};   ///< "n = 1 + 1e-9, 0 to 90 degrees"
    struct Values {
        std::vector<double> values{}, expected{};
    };
    std::function<Values(const JobControl&)> compute{};
    double bound = 1e-9;          ///< largest |value - expected|, relative to the expected where that is above 1
    double low = 0.0, high = 1.0; ///< what no value may leave
};

std::vector<ShadingCase> shadingCases();

struct ShadingRow {
    std::string family{}, name{};
    size_t places = 0;
    double largestError = 0.0; ///< as ShadingCase::bound
    double bound = 0.0;
    std::vector<std::string> failures{}; ///< what does not hold, in words

    bool holds() const { return failures.empty(); }
};

/// Judges values: finite, within the range, within the bound of what is expected.
ShadingRow judgeShading(const ShadingCase& test, const ShadingCase::Values& computed);

/// @throws Cancelled
ShadingRow runShading(const ShadingCase& test, const JobControl& job = {});

} // namespace mirrorball
