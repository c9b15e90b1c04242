// HAS_TEXCOORD: 1 for the views that read texture coordinates. SPHERE_VERTEX: 1 where the place in a painted sphere map is computed at
// vertices and interpolated, as hardware of 1999 did.
uniform mat4 worldToClip;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
#if HAS_TEXCOORD
layout(location = 2) in vec2 vertexTexCoord;
out vec2 texCoord;
#endif
#if SPHERE_VERTEX
#include "lib/disc_place.glsl"
uniform vec4 viewer;
out vec2 vertexDiscPlace;
#endif
out vec3 worldPosition;
out vec3 worldNormal;

void main()
{
    worldPosition = position;
    worldNormal = normal;
#if HAS_TEXCOORD
    texCoord = vertexTexCoord;
#endif
#if SPHERE_VERTEX
    vertexDiscPlace = discPlace(normalize(normal), normalize(viewer.xyz - viewer.w * position));
#endif
    gl_Position = worldToClip * vec4(position, 1.0);
}
