// What a picture's pixels were computed from, for tests and pickers. HAS_TEXCOORD: 1 for what a picker needs besides.
#include "lib/surface_point.glsl"
uniform vec4 viewer;
uniform mat3 specularRotation;
in vec3 worldPosition;
in vec3 worldNormal;
#if HAS_TEXCOORD
in vec2 texCoord;
layout(location = 3) out vec4 surfaceTexCoord;
layout(location = 4) out vec4 reflected; // in the world
#endif
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 direction; // of the specular lookup, in the map's own space

void main()
{
    SurfacePoint p = surfacePoint(viewer, worldPosition, worldNormal);
    position = vec4(worldPosition, 1.0);
    normal = vec4(p.n, 1.0);
    direction = vec4(specularRotation * p.r, 1.0);
#if HAS_TEXCOORD
    surfaceTexCoord = vec4(texCoord, 0.0, 1.0);
    reflected = vec4(p.r, 1.0);
#endif
}
