#include "engine_shaders.h"

#include "core/base/error.h"
#include "core/image/color.h"
#include "core/image/map_file.h"
#include "core/image/probe_file.h"
#include "core/sphere/cube_map.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>

/// Judges pictures that an engine made with our files (prove.mjs takes them), and makes files with a fault for it to find.
///   engine_proof judge MANIFEST.json            prints a JSON object of measured errors; exits with 1 where one is beyond its limit
///   engine_proof plant FAULT ENGINE PROBE DIR   FAULT is flip, law, pi or encoding
namespace mirrorball::proof {
namespace {

using nlohmann::json;

FilterSource sourceOf(const std::string& probe) { return FilterSource(readProbe(probe).map); }

/// A picture from a client, RGB, top row first.
struct Picture {
    int size = 0;
    std::vector<float> rgb{};
    glm::dvec3 at(int x, int y) const
    {
        const float* p = rgb.data() + 3 * (static_cast<size_t>(y) * static_cast<size_t>(size) + static_cast<size_t>(x));
        return {p[0], p[1], p[2]};
    }
};

Picture readPicture(const std::string& path, int size)
{
    std::ifstream stream(path, std::ios::binary);
    Picture picture{size, std::vector<float>(static_cast<size_t>(size) * static_cast<size_t>(size) * 3)};
    stream.read(reinterpret_cast<char*>(picture.rgb.data()), static_cast<std::streamsize>(picture.rgb.size() * sizeof(float)));
    if (!stream)
        throw FileError(path, "is no picture of " + std::to_string(size) + " x " + std::to_string(size) + " floats");
    return picture;
}

/// The ball fills the picture; an orthographic eye looks along -eye. In a left-handed system it stands at -Z.
class Ball {
public:
    Ball(int size, double eyeZ, int block = 1) : m_size(size), m_block(block), m_eyeZ(eyeZ) {}

    /// Pixels near the rim see a lot at once and are left out.
    bool shows(int x, int y) const
    {
        const glm::dvec2 p = place(x, y);
        return glm::dot(p, p) < 0.9 * 0.9;
    }
    Pixel pixel(int x, int y) const
    {
        Pixel result{.normal = normal(x, y), .view = {0.0, 0.0, m_eyeZ}};
        const int qx = x & ~1, qy = y & ~1; // derivatives are differences within quads of pixels
        const glm::dvec3 dx = glm::abs(normal(qx + 1, y) - normal(qx, y)), dy = glm::abs(normal(x, qy + 1) - normal(x, qy));
        const glm::dvec3 largest = glm::max(dx, dy);
        result.normalStep = std::max({largest.x, largest.y, largest.z});
        result.normalVariance = glm::dot(dx, dx) + glm::dot(dy, dy);
        return result;
    }
    glm::dvec3 reflected(const glm::dvec3& n) const
    {
        const glm::dvec3 v(0.0, 0.0, m_eyeZ);
        return 2.0 * glm::dot(n, v) * n - v;
    }
    int size() const { return m_size; }
    int block() const { return m_block; }

private:
    glm::dvec2 place(int x, int y) const { return {(2.0 * x + 1.0) / m_size - 1.0, 1.0 - (2.0 * y + 1.0) / m_size}; }
    glm::dvec3 normal(int x, int y) const
    {
        const glm::dvec2 p = place(x, y);
        return {p.x, p.y, m_eyeZ * std::sqrt(std::max(0.0, 1.0 - glm::dot(p, p)))};
    }

    int m_size, m_block;
    double m_eyeZ;
};

/// How a picture differs from another over the ball.
struct Difference {
    double mean = 0.0;   ///< absolute, over a mean of at least 1
    double scale = 1.0;  ///< mean of the picture over that of the expected
    double relRms = 0.0; ///< rms over the rms of the expected
    double seams = 0.0;  ///< rms where the reflection is within a texel or two of a cube's edge, minus elsewhere; over the expected's rms
};

using Shade = std::function<glm::dvec3(const Pixel&)>;

/// Compares means over blocks of pixels, where the client's picture is one of random samples.
Difference difference(const Picture& seen, const Ball& ball, const Shade& expected, const glm::dmat3& axes)
{
    double absolute = 0.0, level = 0.0, bias = 0.0, squares = 0.0, total = 0.0, atSeams = 0.0;
    long count = 0, seamCount = 0;
    for (int top = 0; top < ball.size(); top += ball.block())
        for (int left = 0; left < ball.size(); left += ball.block()) {
            if (!ball.shows(left, top) || !ball.shows(left + ball.block() - 1, top + ball.block() - 1))
                continue;
            glm::dvec3 truth(0.0), d(0.0);
            bool isSeam = false;
            for (int y = top; y < top + ball.block(); ++y)
                for (int x = left; x < left + ball.block(); ++x) {
                    const Pixel pixel = ball.pixel(x, y);
                    const glm::dvec3 value = expected(pixel);
                    const cube_map::FacePosition face = cube_map::facePosition(axes * ball.reflected(pixel.normal));
                    truth += value;
                    d += seen.at(x, y) - value;
                    isSeam = isSeam || std::max(std::abs(face.s), std::abs(face.t)) > 1.0 - 2.0 / 64.0;
                }
            const double pixels = ball.block() * ball.block();
            truth /= pixels;
            d /= pixels;
            const double square = glm::dot(d, d) / 3.0;
            if (isSeam) {
                atSeams += square;
                ++seamCount;
            }
            absolute += (std::abs(d.r) + std::abs(d.g) + std::abs(d.b)) / 3.0;
            level += (truth.r + truth.g + truth.b) / 3.0;
            bias += (d.r + d.g + d.b) / 3.0;
            squares += square;
            total += glm::dot(truth, truth) / 3.0;
            ++count;
        }
    const double n = static_cast<double>(count), rms = std::sqrt(total / n);
    const double elsewhere = std::sqrt((squares - atSeams) / static_cast<double>(std::max(1L, count - seamCount)));
    return {absolute / n / std::max(1.0, level / n), 1.0 + bias / level, std::sqrt(squares / n) / rms,
            (std::sqrt(atSeams / static_cast<double>(std::max(1L, seamCount))) - elsewhere) / rms};
}

Picture drawn(const Ball& ball, const Shade& shade)
{
    Picture picture{ball.size(), std::vector<float>(static_cast<size_t>(ball.size()) * static_cast<size_t>(ball.size()) * 3)};
    for (int y = 0; y < ball.size(); ++y)
        for (int x = 0; x < ball.size(); ++x)
            if (ball.shows(x, y)) {
                const glm::vec3 rgb(shade(ball.pixel(x, y)));
                std::copy_n(&rgb.x, 3,
                            picture.rgb.data() + 3 * (static_cast<size_t>(y) * static_cast<size_t>(ball.size()) + static_cast<size_t>(x)));
            }
    return picture;
}

std::vector<glm::dmat3> signedPermutations()
{
    std::vector<glm::dmat3> all;
    for (int permutation = 0; permutation < 6; ++permutation)
        for (int signs = 0; signs < 8; ++signs) {
            const int first = permutation % 3, second = (first + 1 + permutation / 3) % 3, third = 3 - first - second;
            glm::dmat3 axes(0.0);
            axes[0][first] = (signs & 1) != 0 ? -1.0 : 1.0;
            axes[1][second] = (signs & 2) != 0 ? -1.0 : 1.0;
            axes[2][third] = (signs & 4) != 0 ? -1.0 : 1.0;
            all.push_back(axes);
        }
    return all;
}

/// "(-X,+Y,+Z)": the client's direction (x, y, z) shows this direction of ours.
std::string words(const glm::dmat3& axes)
{
    std::string text = "(";
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if (axes[column][row] != 0.0)
                text += std::string(row > 0 ? "," : "") + (axes[column][row] > 0.0 ? "+" : "-") + "XYZ"[column];
    return text + ")";
}

std::string orientation(const Picture& mirror, const Ball& ball, const EnvironmentMap& environment)
{
    std::string best;
    double least = 1e300;
    for (const glm::dmat3& axes : signedPermutations()) {
        const auto shade = [&](const Pixel& p) { return glm::dvec3(environment.radiance(axes * ball.reflected(p.normal))); };
        if (const double mean = difference(mirror, ball, shade, axes).mean; mean < least) {
            least = mean;
            best = words(axes);
        }
    }
    return best;
}

constexpr double mirrorLimit = 0.01, roughLimit = 0.02, irradianceLimit = 0.01, shMargin = 0.005, seamLimit = 0.01, ownMargin = 0.005;
/// Of the mean of diffuse light where the engine filters the latlong by itself: a curve or a factor would show, its own filter's error may.
constexpr double scaleLimit = 0.03;
/// Godot 3 keeps its light in small paraboloid maps, mirrors too, and loses 2 to 5 % of diffuse light whatever it is given.
constexpr double godotScaleLimit = 0.06;

std::string rounded(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4f", value);
    return text.data();
}

/// The figures of one engine and probe, with their limits.
class Verdict {
public:
    void add(const std::string& name, double value, double limit)
    {
        m_figures[name] = {{"value", value}, {"limit", limit}, {"passed", value <= limit}};
        m_passed = m_passed && value <= limit;
    }
    /// A figure of a probe that the engine itself cannot show within the limit: its own prefilter of the same latlong is held against the
    /// exact light, as ours is, and ours may be worse by no more than ownMargin.
    void addBesideOwn(const std::string& name, double value, double limit, double ours, double theirs)
    {
        add(name, value, value > limit && ours - theirs <= ownMargin ? value : limit);
        if (value > limit)
            m_figures[name]["expected"] = "at most " + rounded(limit) + "; against the exact light ours is off by " + rounded(ours) +
                                          ", the engine's own by " + rounded(theirs);
    }
    /// A figure that our files do not decide: the engine's own filter.
    void tell(const std::string& name, double value) { m_figures[name + " (its own filter)"] = {{"value", value}, {"passed", true}}; }
    void orientation(const std::string& name, const std::string& seen, const std::string& expected)
    {
        m_figures[name] = {{"value", seen}, {"expected", expected}, {"passed", seen == expected}};
        m_passed = m_passed && seen == expected;
    }
    bool passed() const { return m_passed; }
    const json& figures() const { return m_figures; }

private:
    json m_figures = json::object();
    bool m_passed = true;
};

std::string figureName(const std::string& kind, double roughness)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%s %.2f", kind.c_str(), roughness);
    return text.data();
}

/// One engine's pictures against its run of our light, against the exact light, and beside its own.
class Judge {
public:
    explicit Judge(const json& manifest)
        : m_engine(manifest.at("engine").get<std::string>()), m_profile(engineProfile(m_engine)), m_probe(sourceOf(manifest.at("probe"))),
          m_ball(manifest.at("size"), manifest.value("eye", 1.0), manifest.value("block", 1)),
          m_axes(manifest.value("left_handed", false) ? mirroredInX().axes : glm::dmat3(1.0))
    {
        std::vector<double> roughnesses;
        for (const json& picture : manifest.at("pictures"))
            roughnesses.push_back(picture.value("roughness", 1.0));
        m_exact = ofExactMaps(m_probe, roughnesses);
        m_nine = ofSh(m_probe);
        if (m_profile.law)
            m_levels = ofLevels(m_probe, m_profile, {.size = manifest.value("faces", 0)});
    }

    void look(const json& entry)
    {
        const Picture picture = readPicture(entry.at("file"), m_ball.size());
        const std::string kind = entry.at("kind");
        const double roughness = entry.value("roughness", 1.0);
        const std::string name = kind == "metal" ? figureName(kind, roughness) : kind;
        const Difference againstExact = compare(picture, kind == "metal" ? shadedBy(*m_exact, roughness) : mattBy(*m_exact));
        if (entry.value("own", false)) {
            lookAtItsOwn(kind, name, roughness, picture, againstExact);
            return;
        }
        m_errors[name] = againstExact.relRms;
        if (kind == "metal")
            lookAtMetal(name, roughness, picture, againstExact);
        else
            lookAtDiffuse(kind, picture, againstExact);
    }

    /// Once all pictures were looked at.
    Verdict conclude()
    {
        if (m_profile.law)
            m_absolutes["seams"] = {m_seams, seamLimit, m_exactSeams, m_ownSeams >= 0.0 ? std::optional(m_ownSeams) : std::nullopt};
        for (const auto& [name, figure] : m_absolutes)
            if (figure.theirs)
                m_verdict.addBesideOwn(name, figure.value, figure.limit, figure.ours, *figure.theirs);
            else
                m_verdict.add(name, figure.value, figure.limit);
        return std::move(m_verdict);
    }

private:
    /// What is judged once the engine's own pictures are known, too.
    struct Absolute {
        double value, limit;
        double ours = 0.0; ///< the same figure against the exact light
        std::optional<double> theirs{};
    };

    Shade shadedBy(const Radiance& radiance, double roughness) const
    {
        return [this, &radiance, roughness](const Pixel& p) { return metal(m_engine, radiance, p, roughness, m_axes); };
    }
    Shade mattBy(const Radiance& radiance) const
    {
        return [this, &radiance](const Pixel& p) { return diffuse(radiance, p, m_axes); };
    }
    /// The light that was exported; engines that filter by themselves have the environment to show.
    const Radiance& ours() const { return m_levels ? *m_levels : *m_exact; }
    Difference compare(const Picture& picture, const Shade& shade) const { return difference(picture, m_ball, shade, m_axes); }

    void lookAtItsOwn(const std::string& kind, const std::string& name, double roughness, const Picture& picture,
                      const Difference& againstExact)
    {
        if (kind == "metal" && roughness == 0.0) // else it could excuse anything
            m_verdict.orientation("orientation of its own", orientation(picture, m_ball, *m_probe.latlong()), words(m_axes));
        m_verdict.add("worse than its own, " + name, m_errors.at(name) - againstExact.relRms, ownMargin);
        if (kind == "metal" && roughness > 0.0)
            m_ownSeams = std::max(m_ownSeams, againstExact.seams);
        if (const auto found = m_absolutes.find(kind == "metal" && roughness == 0.0 ? "mirror" : kind); found != m_absolutes.end())
            found->second.theirs = kind == "metal" ? againstExact.mean : againstExact.relRms;
    }

    void lookAtMetal(const std::string& name, double roughness, const Picture& picture, const Difference& againstExact)
    {
        const Difference d = compare(picture, shadedBy(ours(), roughness));
        if (roughness == 0.0) {
            m_verdict.orientation("orientation", orientation(picture, m_ball, *m_probe.latlong()), words(m_axes));
            if (m_engine == "godot") {
                m_verdict.tell("mirror", d.mean);
                m_verdict.add("scale of mirrored light", std::abs(d.scale - 1.0), godotScaleLimit);
            } else {
                m_absolutes["mirror"] = {d.mean, mirrorLimit, againstExact.mean};
            }
        } else if (!m_profile.law) {
            m_verdict.tell(name, d.relRms);
        } else {
            m_verdict.add(name, d.relRms, roughLimit);
            m_seams = std::max(m_seams, d.seams); // what is smooth everywhere shows them
            m_exactSeams = std::max(m_exactSeams, againstExact.seams);
        }
    }

    void lookAtDiffuse(const std::string& kind, const Picture& picture, const Difference& againstExact)
    {
        if (kind == "sh" || m_engine == "babylon") { // nine coefficients miss the higher degrees, whoever makes them
            const RadianceSh whole = radianceSh(m_probe.spectrum(2));
            const Shade shade = [&](const Pixel& p) { return irradianceOverPi(whole, m_axes * p.normal); };
            const double least = compare(drawn(m_ball, shade), mattBy(*m_exact)).relRms;
            m_verdict.add(kind + " (SH) against its run", compare(picture, mattBy(*m_nine)).relRms, irradianceLimit);
            m_verdict.add(kind + " (SH) against exact", againstExact.relRms, least + shMargin);
        } else if (m_profile.law) {
            m_verdict.add(kind + " against its run", compare(picture, mattBy(ours())).relRms, irradianceLimit);
            m_absolutes[kind] = {againstExact.relRms, irradianceLimit, againstExact.relRms};
        } else {
            m_verdict.tell(kind, againstExact.relRms);
            m_verdict.add("scale of diffuse light", std::abs(againstExact.scale - 1.0), m_engine == "godot" ? godotScaleLimit : scaleLimit);
        }
    }

    std::string m_engine;
    const EngineProfile& m_profile;
    FilterSource m_probe;
    Ball m_ball;
    glm::dmat3 m_axes;
    std::unique_ptr<Radiance> m_exact{}, m_nine{};
    std::unique_ptr<Radiance> m_levels{}; ///< null for engines that filter by themselves
    Verdict m_verdict{};
    std::map<std::string, Absolute> m_absolutes{};
    double m_seams = -1.0, m_ownSeams = -1.0, m_exactSeams = -1.0;
    std::map<std::string, double> m_errors{}; ///< against the exact light, ours, by picture
};

Verdict judge(const json& manifest)
{
    Judge judge(manifest);
    for (const json& entry : manifest.at("pictures"))
        judge.look(entry);
    return judge.conclude();
}

/// The profile's files with a fault.
void plant(const std::string& fault, const std::string& engine, const std::string& probeName, const std::string& folder)
{
    EngineProfile profile = engineProfile(engine);
    EnvironmentMap map = readProbe(probeName).map;
    EngineExportOptions options{.name = engine};
    if (fault == "flip") {
        profile.cube = profile.cube == mirroredInX() ? CubeOrientation{} : mirroredInX();
        if (engine == "playcanvas" || !profile.law) // an atlas or a latlong, which are no cubes
            options.yaw = pi;
    } else if (fault == "law") {
        profile.law = RoughnessLaw::Unity;
    }
    for (float& value : map.image.texels) {
        if (fault == "pi")
            value *= static_cast<float>(pi);
        if (fault == "encoding")
            value = encodeSrgb(value);
    }
    FilterSource source(std::move(map));
    exportForEngine(source, profile, options, folder);
}

int run(const std::vector<std::string>& words)
{
    if (words.size() == 2 && words[0] == "judge") {
        std::ifstream stream(words[1]);
        const Verdict verdict = judge(json::parse(stream));
        std::cout << verdict.figures().dump() << '\n';
        return verdict.passed() ? 0 : 1;
    }
    if (words.size() == 5 && words[0] == "plant") {
        plant(words[1], words[2], words[3], words[4]);
        return 0;
    }
    std::cerr << "usage: engine_proof judge MANIFEST.json | plant FAULT ENGINE PROBE DIR\n";
    return 2;
}

} // namespace
} // namespace mirrorball::proof

int main(int argc, char** argv)
{
    try {
        return mirrorball::proof::run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << "engine_proof: " << error.what() << '\n';
        return 2;
    }
}
