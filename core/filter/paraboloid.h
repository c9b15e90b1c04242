#pragma once

#include "lobe.h"

#include "../fields.h"
#include "../image/environment_map.h"
#include "../job.h"

namespace mirrorball {

/// Knobs of the paraboloid method (000 section 3.2.5).
struct ParaboloidKnobs {
    double clamp = 0.1;    ///< (0, 1): the kernel ends where the lobe has fallen to this share of its peak
    int largestKernel = 7; ///< texels across that the convolution can do; the map shrinks until the kernel fits

    bool operator==(const ParaboloidKnobs&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"paraboloid_clamp", "paraboloid: the kernel ends where the lobe has fallen to this share of its peak", 1e-6, 0.999},
              self.clamp);
        visit(Field{"paraboloid_kernel", "paraboloid: largest kernel of the convolution; the map shrinks until it fits", 3, 1023, "texels"},
              self.largestKernel);
    }
};

/// What the paraboloid method needs of a GPU, which core does not know: core/preview implements it on an offscreen context. A
/// FilterSource is handed one; without it the method is refused.
class ParaboloidDevice {
public:
    virtual ~ParaboloidDevice() = default;
    /// The filtered map, as prefilter()'s, by the method of 000 section 3.2.5.
    /// @param latlong  the whole probe
    /// @throws WorkError when the GPU fails; Cancelled
    virtual EnvironmentMap filter(const EnvironmentMap& latlong, const Lobe& lobe, const MapLayout& target, double yaw,
                                  const ParaboloidKnobs& knobs, const JobControl& job) = 0;
};

} // namespace mirrorball
