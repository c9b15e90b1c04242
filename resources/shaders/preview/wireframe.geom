// Gives every vertex its distance on the screen, in pixels, to each side of its triangle; interpolated without perspective that is a
// fragment's distance.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
uniform vec4 viewport; // xy: size in pixels
in vec3 worldPosition[];
in vec3 worldNormal[];
out vec3 facePosition;
out vec3 faceNormal;
noperspective out vec3 edgeDistance;

void main()
{
    bool isBefore = gl_in[0].gl_Position.w > 0.0 && gl_in[1].gl_Position.w > 0.0 && gl_in[2].gl_Position.w > 0.0;
    vec2 p[3];
    for (int i = 0; i < 3; ++i)
        p[i] = 0.5 * viewport.xy * gl_in[i].gl_Position.xy / gl_in[i].gl_Position.w;
    float area = abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x));
    for (int i = 0; i < 3; ++i) {
        edgeDistance = vec3(1e6);
        if (isBefore) {
            edgeDistance = vec3(0.0);
            edgeDistance[i] = area / max(distance(p[(i + 1) % 3], p[(i + 2) % 3]), 1e-6);
        }
        facePosition = worldPosition[i];
        faceNormal = worldNormal[i];
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
