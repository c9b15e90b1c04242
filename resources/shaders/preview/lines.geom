// Makes each line a strip of a width in pixels. Lines of which only some are drawn are taken evenly.
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;
uniform mat4 worldToClip;
uniform vec4 viewport; // xy: size in pixels; z: half the width of a line in pixels
uniform int everyNth;
in vec3 start[];
in vec3 along[];

void main()
{
    if (gl_PrimitiveIDIn % everyNth != 0)
        return;
    vec4 from = worldToClip * vec4(start[0], 1.0), to = worldToClip * vec4(start[0] + along[0], 1.0);
    if (from.w <= 0.0 || to.w <= 0.0)
        return;
    vec2 halfSize = 0.5 * viewport.xy;
    vec2 way = halfSize * to.xy / to.w - halfSize * from.xy / from.w;
    way = length(way) > 1e-3 ? normalize(way) : vec2(1.0, 0.0);
    vec2 aside = viewport.z * vec2(-way.y, way.x) / halfSize;
    gl_Position = vec4(from.xy - from.w * aside, from.zw);
    EmitVertex();
    gl_Position = vec4(from.xy + from.w * aside, from.zw);
    EmitVertex();
    gl_Position = vec4(to.xy - to.w * aside, to.zw);
    EmitVertex();
    gl_Position = vec4(to.xy + to.w * aside, to.zw);
    EmitVertex();
    EndPrimitive();
}
