// HAS_TEXCOORD: 1 for the views that read texture coordinates.
uniform mat4 worldToClip;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
#if HAS_TEXCOORD
layout(location = 2) in vec2 vertexTexCoord;
out vec2 texCoord;
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
    gl_Position = worldToClip * vec4(position, 1.0);
}
