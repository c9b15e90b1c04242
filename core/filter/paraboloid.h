#pragma once

#include "lobe.h"
#include "paraboloid_kernel.h"
#include "transfer_model.h"

#include "core/base/fields.h"
#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Filtering in a dual paraboloid map, where a lobe is nearly (000 section 3.2.5), and in truth exactly, a circle: what a GPU does well.
/// The maps are laid out here; the sums over the texels under the lobe run on a ParaboloidDevice, which core/preview implements in OpenGL.
/// Its twin in double precision is paraboloidSum().
namespace mirrorball {

enum class ParaboloidKernel {
    /// 000 section 3.2.5 as it stands: the map is convolved with one kernel that is right in the middle of a half (map S) and with one that
    /// is right at its rim (map L), each on a map shrunk by boxes until the kernel fits, and the two are blended by d^2.
    Blended,
    /// The kernel of every place as it is: a circle with a displaced center, whose texels weigh what the lobe and their solid angle say.
    /// The map shrinks without losing where its radiance came from, so that the error falls with the fourth power of the kernel's size.
    Exact,
};
std::span<const std::string_view> words(ParaboloidKernel); // blended exact

/// Knobs of the method; resolved() puts in what is left open.
struct ParaboloidKnobs {
    ParaboloidKernel kernel = ParaboloidKernel::Exact;
    double clamp = 0.0;    ///< [0, 1): the lobe ends where it has fallen to this share of its peak; 0: 0.1 for blended, 1e-3 for exact
    int largestKernel = 0; ///< texels across in the middle of the shrunk half; 0: 7 for blended, 17 for exact
    int half = 0;          ///< blended: texels across a half's disc before it shrinks; 0: the height of the probe's latlong form
    int border = 0;        ///< blended: least number of texels around each disc; 0: as far as the kernel reaches

    bool operator==(const ParaboloidKnobs&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"paraboloid", "paraboloid: two kernels blended by the distance from the middle, as published, or exact at every place"},
              self.kernel);
        visit(Field{"paraboloid_clamp",
                    "paraboloid: the kernel ends where the lobe has fallen to this share of its peak; 0: 0.1 blended, 0.001 exact", 0,
                    0.999},
              self.clamp);
        visit(Field{"paraboloid_kernel", "paraboloid: largest kernel; the map shrinks until it fits; 0: 7 blended, 17 exact", 0, 255,
                    "texels"},
              self.largestKernel);
        visit(Field{"paraboloid_half", "paraboloid blended: size of a half before it shrinks; 0: the probe's height", 0, 4096, "texels"},
              self.half);
        visit(Field{"paraboloid_border", "paraboloid blended: least border around each half; 0: as far as the kernel reaches", 0, 2048,
                    "texels"},
              self.border);
    }
};

/// @param probeHeight  of the latlong form
ParaboloidKnobs resolved(ParaboloidKnobs knobs, int probeHeight);

/// Why the method cannot do this; empty where it can. @param knobs resolved
std::string paraboloidRefusal(const Lobe& lobe, const ParaboloidKnobs& knobs);

/// What the method costs against the reference sum: rel_rms for a single bright texel, the most demanding probe there is, where the method
/// is worst (blended at the rim, exact in the middle of a half), by integrating the square of the difference between its effective kernel
/// and the lobe. Other probes show less.
double paraboloidError(const Lobe& lobe, const ParaboloidKnobs& knobs);

/// The same degree by degree, for probes whose spectrum is known. That the lobe ends at its clamp is systematic; interpolation between
/// texels, which makes up the rest of paraboloidError(), grows with the degree as its order says until it has lost all,
///   scatter_l = k_l^2 min(1, (l/l_0)^(2 order)),   order 4 of the exact kernel's cubics, 2 of the blended maps' bilinear lookups
TransferModel paraboloidModel(const Lobe& lobe, const ParaboloidKnobs& knobs, int bandLimit);

/// Seconds on one core of a current server with a software renderer; with a GPU only laying out the halves takes time.
/// @param directions  texels of the target
double paraboloidSeconds(const Lobe& lobe, const ParaboloidKnobs& knobs, int probeWidth, int directions);

/// The two halves as the device is handed them, side by side, front on the left: 2 side x side texels, row 0 on top as in
/// dual_paraboloid.h.
struct ParaboloidHalves {
    ParaboloidKernel kernel = ParaboloidKernel::Exact;
    int side = 0;                    ///< of one half with what lies around its disc; the disc's middle is its middle
    double radius = 0.0;             ///< of the disc, texels
    std::vector<glm::vec4> texels{}; ///< blended: radiance and 1; exact: radiance times solid angle, and solid angle

    KernelSizes sizes{};            ///< blended; side is a multiple of both shrink factors
    SampledKernel small{}, large{}; ///< blended

    Lobe lobe{};        ///< exact
    double reach = 0.0; ///< exact: the angle at which the lobe ends
    /// Exact: a lookup whose direction has less than this along a half's axis finds nothing in that half.
    double leastAlongAxis = -2.0;
};

/// Lays the probe out for a lobe.
///
/// Exact: every texel of the probe is spread over the sixteen texels around its place by the weights that cubic (Lagrange) interpolation at
/// that place would read them with. A sum of k over the halves then equals the reference sum with k replaced by its interpolant: nothing
/// else is approximated, and no bright texel is lost however far the map shrinks.
/// @param knobs  resolved
/// @throws InvalidArgument when paraboloidRefusal() says why; Cancelled
ParaboloidHalves layOutHalves(const EnvironmentMap& latlong, const Lobe& lobe, const ParaboloidKnobs& knobs, const JobControl& job = {});

/// Sums over the halves, in each direction.
class ParaboloidDevice {
public:
    virtual ~ParaboloidDevice() = default;
    /// @param directions  unit
    /// @return radiance
    /// @throws WorkError when there is no GPU context or it fails; Cancelled
    virtual std::vector<glm::vec3> sum(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job) = 0;
    /// What it runs on, for plans and statistics: "llvmpipe (LLVM 15.0.6, 256 bits)".
    virtual std::string description() = 0;
};

/// Twin of ParaboloidDevice::sum() on the CPU in double precision.
std::vector<glm::dvec3> paraboloidSum(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job = {});

} // namespace mirrorball
