// Step 8 of 000 section 3.2.5: one kernel for every texel of both halves. Taps beyond a half are left out, and the others make up for them.
uniform sampler2D source;
uniform sampler2D kernel; // weights, (2 reach + 1)^2
uniform int reach;
layout(location = 0) out vec4 filtered;

void main()
{
    int side = textureSize(source, 0).y;
    ivec2 p = ivec2(gl_FragCoord.xy);
    int left = p.x / side * side;
    ivec2 first = max(ivec2(-reach), ivec2(left, 0) - p), last = min(ivec2(reach), ivec2(left + side, side) - 1 - p);
    vec4 sum = vec4(0.0);
    for (int j = first.y; j <= last.y; ++j)
        for (int i = first.x; i <= last.x; ++i)
            sum += texelFetch(kernel, ivec2(i + reach, j + reach), 0).r * texelFetch(source, p + ivec2(i, j), 0);
    filtered = sum / sum.a;
}
