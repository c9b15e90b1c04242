#include "paraboloid_blur.h"

#include "gl_object.h"
#include "offscreen_context.h"
#include "render_target.h"
#include "shader_program.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace mirrorball::preview {

namespace {

/// Directions lie in a texture of this width, as many rows at a time as give this many taps: stopping then waits for a moment only, and no
/// driver takes the work for a hang.
constexpr int listWidth = 1024;
constexpr double tapsAtATime = 1 << 26;
/// Samples of a lobe over its chord: linear between them is right to 1e-6 of the peak.
constexpr int lobeSamples = 4096;

GlObject floatTexture(int width, int height, GLenum format, GLenum components, const float* texels)
{
    GlObject texture = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(texture, 1, format, width, height);
    if (texels)
        glTextureSubImage2D(texture, 0, 0, 0, width, height, components, GL_FLOAT, texels);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

/// A lobe from its axis to where it ends, equally spaced over the chord 2 sin(t/2), as which it is flat at the axis.
std::vector<float> sampleLobe(const Lobe& lobe, double longestChord)
{
    const LobeShape shape(lobe);
    std::vector<float> samples(lobeSamples);
    for (int i = 0; i < lobeSamples; ++i) {
        const double chord = longestChord * i / (lobeSamples - 1);
        samples[static_cast<size_t>(i)] = static_cast<float>(shape.relative(1.0 - 0.5 * chord * chord));
    }
    return samples;
}

/// Hands out directions a chunk at a time and collects what the shader makes of them.
class DirectionList {
public:
    explicit DirectionList(double tapsPerDirection, size_t count)
        : m_rows(static_cast<int>(std::clamp(
              std::min(tapsAtATime / (listWidth * std::max(1.0, tapsPerDirection)), std::ceil(static_cast<double>(count) / listWidth)), 1.0,
              1024.0))),
          m_directions(floatTexture(listWidth, m_rows, GL_RGBA32F, GL_RGBA, nullptr)),
          m_target(listWidth, m_rows, 1, GL_RGBA32F, 1, GL_NONE)
    {
    }

    template <typename Draw>
    std::vector<glm::vec3> map(std::span<const glm::dvec3> directions, const JobControl& job, Draw&& draw)
    {
        const size_t atATime = static_cast<size_t>(m_rows) * listWidth;
        std::vector<glm::vec4> texels(atATime, glm::vec4(0.0f, 0.0f, 1.0f, 0.0f));
        std::vector<glm::vec3> results(directions.size());
        for (size_t first = 0; first < directions.size(); first += atATime) {
            job.checkStop();
            const size_t count = std::min(atATime, directions.size() - first);
            for (size_t i = 0; i < count; ++i)
                texels[i] = glm::vec4(glm::vec3(directions[first + i]), 0.0f);
            glTextureSubImage2D(m_directions, 0, 0, 0, listWidth, m_rows, GL_RGBA, GL_FLOAT, texels.data());
            glBindTextureUnit(0, m_directions);
            draw(m_target);
            glGetTextureImage(m_target.colors[0], 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(atATime * sizeof(glm::vec4)), texels.data());
            for (size_t i = 0; i < count; ++i)
                results[first + i] = glm::vec3(texels[i]);
            if (job.progress)
                job.progress(static_cast<float>(first + count) / static_cast<float>(directions.size()));
        }
        return results;
    }

private:
    int m_rows;
    GlObject m_directions;
    RenderTarget m_target;
};

} // namespace

struct ParaboloidBlur::Resources {
    OffscreenContext context; // first, so that it outlives what lives in it
    GlObject emptyVertexArray = makeVertexArray();
    ShaderProgram shrink{ShaderStages{"filter/cover.vert", "filter/shrink.frag"}};
    ShaderProgram convolve{ShaderStages{"filter/cover.vert", "filter/convolve.frag"}};
    ShaderProgram blend{ShaderStages{"filter/cover.vert", "filter/blend.frag"}};
    ShaderProgram exact{ShaderStages{"filter/cover.vert", "filter/exact.frag"}};

    ~Resources() { context.makeCurrent(); }

    void cover(const RenderTarget& target, const ShaderProgram& program) const
    {
        program.use();
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        glViewport(0, 0, target.width, target.height);
        glBindVertexArray(emptyVertexArray);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindVertexArray(0);
    }

    RenderTarget filtered(const ParaboloidHalves& halves, const GlObject& map, int factor, const SampledKernel& kernel) const;
    std::vector<glm::vec3> sumBlended(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job) const;
    std::vector<glm::vec3> sumExact(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job) const;
};

/// Steps 4 to 9 of 000 section 3.2.5.
RenderTarget ParaboloidBlur::Resources::filtered(const ParaboloidHalves& halves, const GlObject& map, int factor,
                                                 const SampledKernel& kernel) const
{
    GLuint source = map;
    RenderTarget shrunk;
    int side = halves.side;
    for (int done = 1; done < factor; done *= 2) {
        side /= 2;
        RenderTarget next(2 * side, side, 1, GL_RGBA32F, 1, GL_NONE);
        glBindTextureUnit(0, source);
        shrink.set("source", 0);
        cover(next, shrink);
        shrunk = std::move(next);
        source = shrunk.colors[0];
    }
    const std::vector<float> weights(kernel.weights.begin(), kernel.weights.end());
    const GlObject kernelTexture = floatTexture(kernel.side(), kernel.side(), GL_R32F, GL_RED, weights.data());
    RenderTarget result(2 * side, side, 1, GL_RGBA32F, 1, GL_NONE);
    glBindTextureUnit(0, source);
    glBindTextureUnit(1, kernelTexture);
    convolve.set("source", 0);
    convolve.set("kernel", 1);
    convolve.set("reach", kernel.reach);
    cover(result, convolve);
    return result;
}

std::vector<glm::vec3> ParaboloidBlur::Resources::sumBlended(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions,
                                                             const JobControl& job) const
{
    const GlObject map = floatTexture(2 * halves.side, halves.side, GL_RGBA32F, GL_RGBA, &halves.texels.front().x);
    const RenderTarget small = filtered(halves, map, halves.sizes.smallShrink, halves.small);
    const RenderTarget large = filtered(halves, map, halves.sizes.largeShrink, halves.large);
    return DirectionList(8.0, directions.size()).map(directions, job, [&](const RenderTarget& target) {
        glBindTextureUnit(1, small.colors[0]);
        glBindTextureUnit(2, large.colors[0]);
        blend.set("directions", 0);
        blend.set("smallMap", 1);
        blend.set("largeMap", 2);
        blend.set("halves",
                  glm::vec4(float(halves.side), float(halves.radius), float(halves.sizes.smallShrink), float(halves.sizes.largeShrink)));
        cover(target, blend);
    });
}

std::vector<glm::vec3> ParaboloidBlur::Resources::sumExact(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions,
                                                           const JobControl& job) const
{
    const double chord = 2.0 * std::sin(0.5 * halves.reach);
    const GlObject map = floatTexture(2 * halves.side, halves.side, GL_RGBA32F, GL_RGBA, &halves.texels.front().x);
    const GlObject lobe = floatTexture(lobeSamples, 1, GL_R32F, GL_RED, sampleLobe(halves.lobe, chord).data());
    // The box around the circle, twice as large on average as in the middle of a half.
    const double box = std::pow(2.0 * halves.radius * std::tan(0.5 * halves.reach), 2);
    return DirectionList(2.0 * box, directions.size()).map(directions, job, [&](const RenderTarget& target) {
        glBindTextureUnit(1, map);
        glBindTextureUnit(2, lobe);
        exact.set("directions", 0);
        exact.set("halvesMap", 1);
        exact.set("lobe", 2);
        exact.set("halves", glm::vec4(float(halves.side), float(halves.radius), float(halves.leastAlongAxis), 0.0f));
        exact.set("reach", glm::vec4(float(std::cos(halves.reach)), float(std::sin(halves.reach)), float(chord), float(lobeSamples - 1)));
        cover(target, exact);
    });
}

ParaboloidBlur::ParaboloidBlur() = default;

ParaboloidBlur::~ParaboloidBlur()
{
    const CurrentContextGuard guard;
    m_resources.reset();
}

ParaboloidBlur::Resources& ParaboloidBlur::resources()
{
    if (m_resources)
        m_resources->context.makeCurrent();
    else
        m_resources = std::make_unique<Resources>();
    return *m_resources;
}

std::vector<glm::vec3> ParaboloidBlur::sum(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job)
{
    const CurrentContextGuard guard;
    const Resources& gl = resources();
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (2 * halves.side > largest)
        throw WorkError("paraboloid: halves of " + std::to_string(halves.side) + " texels are more than the OpenGL driver takes (" +
                        std::to_string(largest / 2) + "); use a smaller paraboloid_half or paraboloid_kernel");
    std::vector<glm::vec3> result =
        halves.kernel == ParaboloidKernel::Blended ? gl.sumBlended(halves, directions, job) : gl.sumExact(halves, directions, job);
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw WorkError("paraboloid: the OpenGL driver is out of memory; use a smaller paraboloid_half or paraboloid_kernel");
    return result;
}

std::string ParaboloidBlur::description()
{
    const CurrentContextGuard guard;
    return resources().context.description();
}

} // namespace mirrorball::preview
