// Lines in space, one a vertex: from `start` along `along`. LINES_OF 1: the normals of a mesh; 2: the edges of a box, twelve vertices.
out vec3 start;
out vec3 along;
#if LINES_OF == 1
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform float lineLength;
void main()
{
    start = position;
    along = lineLength * normal;
    gl_Position = vec4(0.0);
}
#else
uniform vec4 boxLow;
uniform vec4 boxHigh;
void main()
{
    int axis = gl_VertexID / 4, first = (axis + 1) % 3, second = (axis + 2) % 3;
    start = boxLow.xyz;
    start[first] = (gl_VertexID & 1) != 0 ? boxHigh[first] : boxLow[first];
    start[second] = (gl_VertexID & 2) != 0 ? boxHigh[second] : boxLow[second];
    along = vec3(0.0);
    along[axis] = boxHigh[axis] - boxLow[axis];
    gl_Position = vec4(0.0);
}
#endif
