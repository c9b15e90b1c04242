// What a picture's pixels were computed from, for tests and pickers. PICK: 1 for what a picker needs besides;
// NORMAL_MAP: whether normals are those of a picture.
#include "lib/surface_point.glsl"
#if NORMAL_MAP
#include "lib/normal_map.glsl"
#endif
uniform vec4 viewer;
uniform mat3 specularRotation;
in vec3 worldPosition;
in vec3 worldNormal;
#if PICK || NORMAL_MAP
in vec2 texCoord;
#endif
#if PICK
layout(location = 3) out vec4 surfaceTexCoord;
layout(location = 4) out vec4 reflected; // in the world
#endif
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 direction; // of the specular lookup, in the map's own space

void main()
{
    SurfacePoint p = surfacePoint(viewer, worldPosition, worldNormal);
#if NORMAL_MAP
    p = mappedPoint(p, viewer, worldPosition, texCoord);
#endif
    position = vec4(worldPosition, 1.0);
    normal = vec4(p.n, 1.0);
    direction = vec4(specularRotation * p.r, 1.0);
#if PICK
    surfaceTexCoord = vec4(texCoord, 0.0, 1.0);
    reflected = vec4(p.r, 1.0);
#endif
}
