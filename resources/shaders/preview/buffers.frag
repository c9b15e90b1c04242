// What a picture's pixels were computed from, for tests and pickers.
#include "lib/surface_point.glsl"
uniform vec4 viewer;
uniform mat3 specularRotation;
in vec3 worldPosition;
in vec3 worldNormal;
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 direction; // of the specular lookup, in the map's own space

void main()
{
    SurfacePoint p = surfacePoint(viewer, worldPosition, worldNormal);
    position = vec4(worldPosition, 1.0);
    normal = vec4(p.n, 1.0);
    direction = vec4(specularRotation * p.r, 1.0);
}
