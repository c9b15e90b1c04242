// Puts what is closed to a second look at the object in front of it, at depth 0: pixels that look like their neighbors. Pixels at an edge,
// where one lookup a pixel cannot tell how much of the pixel lies on either side, keep their depth. OBJECT_SAMPLES: as many as were drawn.
#if OBJECT_SAMPLES > 1
uniform sampler2DMS objectSamples;
#else
uniform sampler2D objectSamples;
#endif

// A step that shows, of square roots of light on the display: about a tenth of the way from black to white.
const float visibleStep = 0.08;

// What the object shows of a pixel, or nothing where no sample lies on it.
vec4 shown(ivec2 pixel)
{
    for (int i = 0; i < OBJECT_SAMPLES; ++i) {
        vec4 one = texelFetch(objectSamples, pixel, i);
        if (one.a > 0.0)
            return vec4(sqrt(max(one.rgb, 0.0)), 1.0);
    }
    return vec4(0.0);
}

float stepTo(vec4 here, ivec2 pixel)
{
    vec4 there = shown(pixel);
    vec3 difference = abs(here.rgb - there.rgb);
    return there.a * max(difference.r, max(difference.g, difference.b));
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 here = shown(pixel);
    float most = max(max(stepTo(here, pixel + ivec2(1, 0)), stepTo(here, pixel - ivec2(1, 0))),
                     max(stepTo(here, pixel + ivec2(0, 1)), stepTo(here, pixel - ivec2(0, 1))));
    if (here.a > 0.0 && most > visibleStep)
        discard;
    gl_FragDepth = 0.0;
}
