// Where each pixel looks the painted sphere map up, for pens. WINDOW 1: through the pane of a window, in the nearest layer outside.
// NORMAL_MAP: whether normals are those of a picture.
#if WINDOW
#include "lib/window_view.glsl"
uniform float layerDepth;
in vec2 texCoord;
#else
#include "lib/disc_place.glsl"
#include "lib/surface_point.glsl"
#if NORMAL_MAP
#include "lib/normal_map.glsl"
in vec2 texCoord;
#endif
in vec3 worldNormal;
#if SPHERE_VERTEX
in vec2 vertexDiscPlace;
#endif
#endif
uniform vec4 viewer;
uniform float noPlace;
in vec3 worldPosition;
layout(location = 0) out vec2 place;

void main()
{
#if WINDOW
    bool isPane = int(texCoord.x + 0.5) == 3;
    place = isPane ? windowPlace(worldPosition, normalize(worldPosition * viewer.w - viewer.xyz), layerDepth) : vec2(noPlace);
#elif SPHERE_VERTEX
    place = vertexDiscPlace;
#else
    SurfacePoint p = surfacePoint(viewer, worldPosition, worldNormal);
#if NORMAL_MAP
    p = mappedPoint(p, viewer, worldPosition, texCoord);
#endif
    place = discPlace(p.n, normalize(viewer.xyz - viewer.w * worldPosition));
#endif
}
