// One color, meant for the display. ENCODED: nothing comes after.
#include "lib/color.glsl"
uniform vec3 lineColor;
layout(location = 0) out vec4 color;

void main()
{
#if ENCODED
    color = vec4(encodeSrgb(lineColor), 1.0);
#else
    color = vec4(lineColor, 1.0);
#endif
}
