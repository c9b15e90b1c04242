#pragma once
// Twin: levelColor() in core/preview/render_settings.
vec3 levelColor(float level)
{
    const vec3 colors[8] = vec3[8](vec3(0.03, 0.09, 0.6), vec3(0.0, 0.45, 0.75), vec3(0.02, 0.45, 0.08), vec3(0.85, 0.75, 0.03),
                                   vec3(0.9, 0.28, 0.02), vec3(0.65, 0.02, 0.02), vec3(0.7, 0.05, 0.6), vec3(1.0));
    level = clamp(level, 0.0, 7.0);
    int below = min(int(level), 6);
    return mix(colors[below], colors[below + 1], level - float(below));
}
