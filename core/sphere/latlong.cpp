#include "latlong.h"

namespace mirrorball::latlong {

Texel acrossSeam(int n, int x, int y)
{
    if (y < 0 || y >= n) { // over a pole, and half a turn on
        y = y < 0 ? -1 - y : 2 * n - 1 - y;
        x += n;
    }
    x %= 2 * n;
    return {x < 0 ? x + 2 * n : x, y};
}

} // namespace mirrorball::latlong
