// Step 6 of 000 section 3.2.5: half the size, by boxes. Row 0 of every texture here is the top row of its image.
uniform sampler2D source;
layout(location = 0) out vec4 shrunk;

void main()
{
    ivec2 p = 2 * ivec2(gl_FragCoord.xy);
    shrunk = 0.25 * (texelFetch(source, p, 0) + texelFetch(source, p + ivec2(1, 0), 0) + texelFetch(source, p + ivec2(0, 1), 0) +
                     texelFetch(source, p + ivec2(1, 1), 0));
}
