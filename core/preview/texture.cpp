#include "texture.h"

#include "core/base/error.h"
#include "core/sphere/disc.h"
#include "core/sphere/dual_paraboloid.h"

#include <algorithm>
#include <cmath>

namespace mirrorball::preview {

namespace {

constexpr float largestHalf = 65504.0f;

// The smallest power of two that brings every texel into a half's range: dividing by it rounds nothing.
float scaleFor(std::span<const EnvironmentMap> levels, TexelFormat format)
{
    float largest = 0.0f;
    for (const EnvironmentMap& level : levels)
        for (const float value : level.image.texels)
            if (std::isfinite(value))
                largest = std::max(largest, std::abs(value));
    return format == TexelFormat::Float || largest <= largestHalf ? 1.0f : std::exp2(std::ceil(std::log2(largest / largestHalf)));
}

void copyTexel(const glm::vec3& radiance, float scale, float* to)
{
    for (int c = 0; c < 3; ++c)
        to[c] = radiance[c] / scale;
    to[3] = 1.0f;
}

glm::vec3 texelAt(const Image& image, int x, int y)
{
    const float* t = image.texel(x, y);
    return {t[0], t[1], t[2]};
}

// Bilinear among those of the four texels around p whose centers the disc holds: the others may be anything.
glm::vec3 withinDisc(const Image& image, const disc::Disc& disc, const glm::dvec2& p)
{
    const glm::dvec2 corner = glm::floor(p - 0.5), fraction = p - 0.5 - corner;
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (int k = 0; k < 4; ++k) {
        const int x = static_cast<int>(corner.x) + k % 2, y = static_cast<int>(corner.y) + k / 2;
        const double weight = (k % 2 ? fraction.x : 1.0 - fraction.x) * (k / 2 ? fraction.y : 1.0 - fraction.y);
        if (weight > 0.0 && disc.holdsCenter(x, y)) {
            sum += weight * glm::dvec3(texelAt(image, x, y));
            total += weight;
        }
    }
    const Texel inner = disc.innerTexel(p);
    return total < 1e-6 ? texelAt(image, inner.x, inner.y) : glm::vec3(sum / total);
}

// What the texel at (x, y) of the disc of this chart stands for, be it in the image or in the frame. Past the rim that is its continued
// direction, looked up in the other half or on the far side of the same disc, as EnvironmentMap::radiance does for its taps. A
// paraboloid's border holds such values already.
glm::vec3 discTexel(const EnvironmentMap& map, int chart, int x, int y)
{
    const MapLayout& layout = map.layout;
    const glm::dvec2 center(x + 0.5, y + 0.5);
    const bool isHalf = mapping(layout.kind).charts == Charts::Halves, isBack = chart == 1;
    const disc::Disc here = isHalf ? dual_paraboloid::half(layout.size, layout.border, isBack) : disc::inscribed(layout.size);
    const int left = chart * layout.size;
    const bool isInImage = x >= left && x < left + layout.size && y >= 0 && y < layout.size;
    if (here.holdsCenter(x, y) || (isInImage && layout.border > 0))
        return texelAt(map.image, x, y);
    if (!isHalf)
        return withinDisc(map.image, here, coordinate(layout, direction(layout, center)));
    const disc::Disc there = dual_paraboloid::half(layout.size, layout.border, !isBack);
    const glm::dvec2 q = here.fromImage(center);
    return withinDisc(map.image, there, there.toImage(q / glm::dot(q, q)));
}

// What a bilinear tap at (x, y) reads, in the image or one texel beyond its chart.
glm::vec3 framedTexel(const EnvironmentMap& map, int chart, int x, int y)
{
    if (mapping(map.layout.kind).hasDiscs())
        return discTexel(map, chart, x, y);
    const Texel across = acrossSeam(map.layout, {0, 0}, x, y);
    return texelAt(map.image, across.x, across.y);
}

void checkSize(GLenum limit, int size)
{
    GLint largest = 0;
    glGetIntegerv(limit, &largest);
    if (size > largest)
        throw WorkError("environment map: a texture of " + std::to_string(size) + " texels is more than the OpenGL driver takes (" +
                        std::to_string(largest) + "); give the preview a smaller map");
}

void check(std::span<const EnvironmentMap> levels)
{
    if (levels.empty() || levels.size() > static_cast<size_t>(EnvironmentTexture::maxLevels))
        throw InvalidArgument("environment map: 1 to 16 levels are needed, not " + std::to_string(levels.size()));
    for (size_t i = 0; i < levels.size(); ++i) {
        const MapLayout& layout = levels[i].layout;
        const Image& image = levels[i].image;
        if (image.width != layout.width() || image.height != layout.height() || image.channels != 3)
            throw InvalidArgument("environment map: the image of level " + std::to_string(i) + " does not have its layout's size in RGB");
        if (layout.kind != levels[0].layout.kind)
            throw InvalidArgument("environment map: level " + std::to_string(i) + " has another parameterization than level 0");
        if (layout.kind == Parameterization::Cube && layout.size != std::max(1, levels[0].layout.size >> i))
            throw InvalidArgument("environment map: level " + std::to_string(i) + " of a cube must have half the size of the one before");
    }
}

} // namespace

EnvironmentTexture::EnvironmentTexture(std::span<const EnvironmentMap> levels, TexelFormat format)
{
    check(levels);
    m_kind = levels[0].layout.kind;
    m_levelCount = static_cast<int>(levels.size());
    m_scale = scaleFor(levels, format);
    // Four channels although three are used: software rasterisers fetch whole vectors faster.
    const GLenum internalFormat = format == TexelFormat::Half ? GL_RGBA16F : GL_RGBA32F;
    if (m_kind == Parameterization::Cube)
        uploadCube(levels, internalFormat);
    else
        uploadAtlas(levels, internalFormat);
}

void EnvironmentTexture::uploadCube(std::span<const EnvironmentMap> levels, GLenum internalFormat)
{
    checkSize(GL_MAX_CUBE_MAP_TEXTURE_SIZE, levels[0].layout.size);
    m_texture = makeTexture(GL_TEXTURE_CUBE_MAP);
    glTextureStorage2D(m_texture, m_levelCount, internalFormat, levels[0].layout.size, levels[0].layout.size);
    std::vector<float> texels;
    for (int i = 0; i < m_levelCount; ++i) {
        const EnvironmentMap& map = levels[static_cast<size_t>(i)];
        const int size = map.layout.size;
        texels.resize(static_cast<size_t>(size) * static_cast<size_t>(size) * 6 * 4);
        float* to = texels.data();
        for (int y = 0; y < 6 * size; ++y)
            for (int x = 0; x < size; ++x, to += 4)
                copyTexel(texelAt(map.image, x, y), m_scale, to);
        glTextureSubImage3D(m_texture, i, 0, 0, 0, size, size, 6, GL_RGBA, GL_FLOAT, texels.data());
        m_levels.emplace_back(0.0f, 0.0f, float(size), 0.0f);
    }
    glTextureParameteri(m_texture, GL_TEXTURE_MIN_FILTER, m_levelCount > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_MAX_LEVEL, m_levelCount - 1);
}

// Level 0 stands at the top, the others in a row below it: each is half as wide as the one before, so all fit.
void EnvironmentTexture::uploadAtlas(std::span<const EnvironmentMap> levels, GLenum internalFormat)
{
    const int charts = mapping(m_kind).chartCount();
    struct Place {
        int x, y, width, height; // of one framed chart
    };
    std::vector<Place> places;
    int atlasWidth = 0, atlasHeight = 0, x = 0;
    for (size_t i = 0; i < levels.size(); ++i) {
        const MapLayout& layout = levels[i].layout;
        const Place place{i == 0 ? 0 : x, i == 0 ? 0 : places[0].height, layout.width() / charts + 2, layout.height() + 2};
        x = i == 0 ? 0 : x + charts * place.width;
        atlasWidth = std::max(atlasWidth, place.x + charts * place.width);
        atlasHeight = std::max(atlasHeight, place.y + place.height);
        places.push_back(place);
    }
    checkSize(GL_MAX_TEXTURE_SIZE, std::max(atlasWidth, atlasHeight));

    m_texture = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(m_texture, 1, internalFormat, atlasWidth, atlasHeight);
    std::vector<float> texels;
    for (size_t i = 0; i < levels.size(); ++i) {
        const EnvironmentMap& map = levels[i];
        const Place& place = places[i];
        const int width = place.width - 2;
        texels.resize(static_cast<size_t>(place.width) * static_cast<size_t>(place.height) * 4);
        for (int chart = 0; chart < charts; ++chart) {
            float* to = texels.data();
            for (int row = -1; row < place.height - 1; ++row)
                for (int column = -1; column < place.width - 1; ++column, to += 4)
                    copyTexel(framedTexel(map, chart, chart * width + column, row), m_scale, to);
            glTextureSubImage2D(m_texture, 0, place.x + chart * place.width, place.y, place.width, place.height, GL_RGBA, GL_FLOAT,
                                texels.data());
        }
        m_levels.emplace_back(float(place.x + 1), float(place.y + 1), float(map.layout.size), float(map.layout.border));
    }
    glTextureParameteri(m_texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(m_texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

} // namespace mirrorball::preview
