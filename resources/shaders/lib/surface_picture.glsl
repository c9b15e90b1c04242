#pragma once
// A picture on a mesh by its texture coordinates: (0, 0) is the lower left, row 0 of the texture the top. Texels: core/scene/surface_picture.
vec4 onSurface(sampler2D picture, vec2 texCoord)
{
    return texture(picture, vec2(texCoord.x, 1.0 - texCoord.y));
}
