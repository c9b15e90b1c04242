#pragma once
// A ring about the place where the object mirrors one direction, and a point in it. Their size is in pixels: the angle to the direction
// grows from 0 in its middle like a cone, so that divided by its own slope it is the distance on the screen.
uniform vec3 marker;       // unit, in the specular map
uniform float markerPixel; // device pixels to a pixel of the window
vec3 marked(vec3 color, vec3 direction)
{
    float angle = acos(clamp(dot(direction, marker), -1.0, 1.0));
    float distance = angle / max(length(vec2(dFdx(angle), dFdy(angle))), 1e-6) / markerPixel;
    float ring = abs(distance - 8.0);
    color = mix(color, vec3(0.0), clamp(2.5 - ring, 0.0, 1.0));
    color = mix(color, vec3(1.0, 0.45, 0.05), clamp(1.5 - ring, 0.0, 1.0));
    return mix(color, vec3(1.0, 0.45, 0.05), clamp(2.0 - distance, 0.0, 1.0));
}
