#include "report.h"

#include <array>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 4> stateWords{"measured", "refused", "left-out", "failed"};
constexpr std::array<std::string_view, 2> axisWords{"probe-width", "exponent"};

} // namespace

std::span<const std::string_view> words(MeasurementState) { return stateWords; }

std::span<const std::string_view> words(GrowthAxis) { return axisWords; }

} // namespace mirrorball
