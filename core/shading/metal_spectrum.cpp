#include "metal_spectrum.h"

#include <array>

namespace mirrorball {

namespace {

// Rows of the tables of the refractiveindex.info database (M. Polyanskiy, CC0): P. B. Johnson and R. W. Christy, Phys. Rev. B 6, 4370
// (1972) for the noble metals and Phys. Rev. B 9, 5056 (1974) for chromium and iron; A. D. Rakic, Appl. Opt. 34, 4755 (1995) for
// aluminium.
constexpr std::array silver{
    IndexRow{367.9, 0.07, 1.657}, IndexRow{381.5, 0.05, 1.864}, IndexRow{397.4, 0.05, 2.07},  IndexRow{413.3, 0.05, 2.275},
    IndexRow{430.5, 0.04, 2.462}, IndexRow{450.9, 0.04, 2.657}, IndexRow{471.4, 0.05, 2.869}, IndexRow{495.9, 0.05, 3.093},
    IndexRow{520.9, 0.05, 3.324}, IndexRow{548.6, 0.06, 3.586}, IndexRow{582.1, 0.05, 3.858}, IndexRow{616.8, 0.06, 4.152},
    IndexRow{659.5, 0.05, 4.483}, IndexRow{704.5, 0.04, 4.838}, IndexRow{756, 0.03, 5.242},   IndexRow{821.1, 0.04, 5.727},
};
constexpr std::array gold{
    IndexRow{367.9, 1.48, 1.895}, IndexRow{381.5, 1.46, 1.933}, IndexRow{397.4, 1.47, 1.952}, IndexRow{413.3, 1.46, 1.958},
    IndexRow{430.5, 1.45, 1.948}, IndexRow{450.9, 1.38, 1.914}, IndexRow{471.4, 1.31, 1.849}, IndexRow{495.9, 1.04, 1.833},
    IndexRow{520.9, 0.62, 2.081}, IndexRow{548.6, 0.43, 2.455}, IndexRow{582.1, 0.29, 2.863}, IndexRow{616.8, 0.21, 3.272},
    IndexRow{659.5, 0.14, 3.697}, IndexRow{704.5, 0.13, 4.103}, IndexRow{756, 0.14, 4.542},   IndexRow{821.1, 0.16, 5.083},
};
constexpr std::array copper{
    IndexRow{367.9, 1.36, 1.975}, IndexRow{381.5, 1.33, 2.045}, IndexRow{397.4, 1.32, 2.116}, IndexRow{413.3, 1.28, 2.207},
    IndexRow{430.5, 1.25, 2.305}, IndexRow{450.9, 1.24, 2.397}, IndexRow{471.4, 1.25, 2.483}, IndexRow{495.9, 1.22, 2.564},
    IndexRow{520.9, 1.18, 2.608}, IndexRow{548.6, 1.02, 2.577}, IndexRow{582.1, 0.7, 2.704},  IndexRow{616.8, 0.3, 3.205},
    IndexRow{659.5, 0.22, 3.747}, IndexRow{704.5, 0.21, 4.205}, IndexRow{756, 0.24, 4.665},   IndexRow{821.1, 0.26, 5.18},
};
constexpr std::array aluminium{
    IndexRow{364.66, 0.39877, 4.3957}, IndexRow{413.28, 0.52135, 5.0008}, IndexRow{442.8, 0.6079, 5.3676},
    IndexRow{476.87, 0.7278, 5.7781},  IndexRow{516.6, 0.8734, 6.2418},   IndexRow{563.57, 1.0728, 6.7839},
    IndexRow{619.93, 1.366, 7.4052},   IndexRow{652.25, 1.5724, 7.7354},  IndexRow{688.81, 1.8301, 8.0601},
    IndexRow{729.32, 2.1606, 8.3565},  IndexRow{774.91, 2.6154, 8.4914},  IndexRow{794.78, 2.7675, 8.3866},
};
constexpr std::array chromium{
    IndexRow{368, 1.87, 2.69}, IndexRow{381, 1.92, 2.74}, IndexRow{397, 2, 2.83},    IndexRow{413, 2.08, 2.93},
    IndexRow{431, 2.19, 3.04}, IndexRow{451, 2.33, 3.14}, IndexRow{471, 2.51, 3.24}, IndexRow{496, 2.75, 3.3},
    IndexRow{521, 2.94, 3.33}, IndexRow{549, 3.18, 3.33}, IndexRow{582, 3.22, 3.3},  IndexRow{617, 3.17, 3.3},
    IndexRow{659, 3.09, 3.34}, IndexRow{704, 3.05, 3.39}, IndexRow{756, 3.08, 3.42}, IndexRow{821, 3.2, 3.48},
};
constexpr std::array iron{
    IndexRow{368, 2.02, 2.43}, IndexRow{381, 2.12, 2.5},  IndexRow{397, 2.24, 2.58}, IndexRow{413, 2.35, 2.65},
    IndexRow{431, 2.48, 2.71}, IndexRow{451, 2.59, 2.77}, IndexRow{471, 2.67, 2.82}, IndexRow{496, 2.74, 2.88},
    IndexRow{521, 2.86, 2.91}, IndexRow{549, 2.95, 2.93}, IndexRow{582, 2.94, 2.99}, IndexRow{617, 2.88, 3.05},
    IndexRow{659, 2.92, 3.1},  IndexRow{704, 2.86, 3.19}, IndexRow{756, 2.87, 3.28}, IndexRow{821, 2.94, 3.39},
};

struct MetalRows {
    std::string_view name;
    std::span<const IndexRow> rows;
};
const std::array metals{MetalRows{"silver", silver},       MetalRows{"gold", gold},         MetalRows{"copper", copper},
                        MetalRows{"aluminium", aluminium}, MetalRows{"chromium", chromium}, MetalRows{"iron", iron}};

} // namespace

std::span<const IndexRow> metalSpectrum(std::string_view name)
{
    for (const MetalRows& metal : metals)
        if (metal.name == name)
            return metal.rows;
    return {};
}

std::string metalNames()
{
    std::string names;
    for (const MetalRows& metal : metals)
        names += (names.empty() ? "" : ", ") + std::string(metal.name);
    return names;
}

} // namespace mirrorball
