// What a picture's pixels were computed from, for tests and pickers.
uniform vec4 viewer;
uniform mat3 specularRotation;
in vec3 worldPosition;
in vec3 worldNormal;
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 direction; // of the specular lookup, in the map's own space

void main()
{
    vec3 n = normalize(gl_FrontFacing ? worldNormal : -worldNormal);
    vec3 v = normalize(viewer.xyz - viewer.w * worldPosition);
    position = vec4(worldPosition, 1.0);
    normal = vec4(n, 1.0);
    direction = vec4(specularRotation * (2.0 * dot(n, v) * n - v), 1.0);
}
