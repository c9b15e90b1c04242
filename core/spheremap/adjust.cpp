#include "adjust.h"

namespace mirrorball {

SpanAdjustment prepare(const InvertLayer&, const Level&)
{
    return [](const DiscSpan& at, ColorSpan& below) {
        for (float* channel : {below.r, below.g, below.b})
            for (int i = 0; i < at.count; ++i)
                channel[i] = std::max(1.0f - channel[i], 0.0f);
    };
}

} // namespace mirrorball
