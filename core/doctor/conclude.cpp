#include "diagnosis.h"

#include "core/engine/engine_profile.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace mirrorball {

namespace {

constexpr double energyTolerance = 0.02; ///< relative; formats round by up to 1.6 %
constexpr double errorWorthAFault = 0.15;

template <typename... Values>
std::string text(const char* format, Values... values)
{
    std::array<char, 512> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, values...);
    return buffer.data();
}

class Conclusion {
public:
    explicit Conclusion(Diagnosis& diagnosis) : d(diagnosis) {}

    void run()
    {
        values();
        if (d.orientation)
            orientation();
        curve();
        clipping();
        if (!d.withProbe && !d.levelZeroIsProbe)
            note("probe", "There is one level, and nothing to compare it with.", "Give the probe that it was made from: --probe SOURCE.");
        if (!measured())
            return;
        scale();
        law();
        engines();
        levels();
        shift();
    }

private:
    Diagnosis& d;

    bool measured() const { return d.withProbe || d.levelZeroIsProbe; }
    void fault(std::string kind, std::string what, std::string cure)
    {
        d.findings.push_back({Severity::Fault, std::move(kind), std::move(what), std::move(cure)});
    }
    void note(std::string kind, std::string what, std::string cure = {})
    {
        d.findings.push_back({Severity::Note, std::move(kind), std::move(what), std::move(cure)});
    }

    /// "level 3", "levels 1, 2 and 5", "all levels"
    std::string levelList(const std::vector<size_t>& list) const
    {
        if (list.size() == d.levels.size() && list.size() > 1)
            return "all levels";
        std::string words = list.size() > 1 ? "levels " : "level ";
        for (size_t i = 0; i < list.size(); ++i)
            words += (i == 0 ? "" : i + 1 == list.size() ? " and " : ", ") + std::to_string(list[i]);
        return words;
    }
    template <typename Test>
    std::vector<size_t> levelsWhere(Test&& test) const
    {
        std::vector<size_t> list;
        for (size_t l = 0; l < d.levels.size(); ++l)
            if (test(d.levels[l]))
                list.push_back(l);
        return list;
    }

    void values()
    {
        std::int64_t nan = 0, infinite = 0;
        for (const LevelDiagnosis& level : d.levels) {
            nan += level.repaired.nan;
            infinite += level.repaired.positiveInfinity + level.repaired.negativeInfinity;
        }
        if (nan > 0)
            fault("nan", text("%lld values are no numbers (NaN).", static_cast<long long>(nan)),
                  "Filter again from a probe without NaN; a filter spreads one over its whole lobe.");
        if (infinite > 0)
            fault("infinite", text("%lld values are infinite: half floats overflowed.", static_cast<long long>(infinite)),
                  "Clamp to 65504 when writing half floats, or store 32-bit floats.");
        const auto negative = levelsWhere([](const LevelDiagnosis& level) {
            return level.smallest < -1e-3 * std::max({level.mean.r, level.mean.g, level.mean.b, 1e-30});
        });
        if (!negative.empty())
            fault("negative", "There are negative values in " + levelList(negative) + ".",
                  "They come from ringing of a filter, or from lossy compression; clamp them to 0 or filter by a positive method.");
        const auto smaller = levelsWhere([&](const LevelDiagnosis& level) { return level.layout.size > d.levels.front().layout.size; });
        if (!smaller.empty())
            fault("order", "Level 0 is not the largest: " + levelList(smaller) + " is larger.",
                  "Number the levels from the largest, 0, to the smallest.");
    }

    void faces(const Orientation& o)
    {
        for (const int face : o.strayFaces) {
            const FacePlace& shows = o.places[static_cast<size_t>(face)];
            const FacePlace& should = o.storage.places[static_cast<size_t>(face)];
            std::string what = "Face " + std::to_string(face) + " (" + faceName(face) + ")";
            if (shows.face != should.face) {
                fault("face", what + " shows what belongs into face " + placeOf(o, shows.face) + ".",
                      "Exchange the faces so that each stands in its place: the order is +X -X +Y -Y +Z -Z.");
                continue;
            }
            // The turn of the picture against the one it should have.
            FaceTurn turn = 0;
            for (FaceTurn t = 0; t < allFaceTurns; ++t) {
                bool same = true;
                for (int k = 0; k < 3; ++k) {
                    const TurnedTexel inner = turnedTexel(t, 2, k & 1, k >> 1), a = turnedTexel(should.turn, 2, inner.x, inner.y),
                                      b = turnedTexel(shows.turn, 2, k & 1, k >> 1);
                    same = same && a.x == b.x && a.y == b.y;
                }
                if (same)
                    turn = t;
            }
            fault("face", what + " is " + describeTurn(turn) + ".", "Turn or mirror that face back; the others are right.");
        }
    }
    /// The stored face that should show a face of the environment.
    static std::string placeOf(const Orientation& o, int shown)
    {
        for (int i = 0; i < 6; ++i)
            if (o.storage.places[static_cast<size_t>(i)].face == shown)
                return std::to_string(i) + " (" + faceName(i) + ")";
        return faceName(shown);
    }

    void orientation()
    {
        const Orientation& o = *d.orientation;
        if (!o.certain()) {
            note("orientation",
                 text("The orientation cannot be told with certainty (match %.2f, next best %.2f): ", o.match, o.nextMatch) + describe(o) +
                     " fits best.",
                 "Compare with a probe whose sides differ, such as builtin:axes; check that SOURCE is what the map was made from.");
            return;
        }
        faces(o);
        const bool cube = d.kind == Parameterization::Cube, ownAxes = o.storage.axes == glm::dmat3(1.0);
        const bool upright = o.storage.axes[1] == glm::dvec3(0.0, 1.0, 0.0);
        if (!upright)
            fault("orientation", "The axes are exchanged: " + describe(o) + (o.mirrored() ? "; that is mirrored." : "."),
                  "Often a map with +Z up: turn the environment so that +Y is up before it is cut into faces.");
        if (o.storage.turn == rowsBottomUp && o.mirrored())
            note("orientation", "The cube is mirrored in X and its rows stand bottom up, as Babylon.js' .env files have them.",
                 "Any other reader must take the rows of each face from below.");
        else if (o.storage.turn != 0)
            fault("orientation", "Every face is " + describeTurn(o.storage.turn) + ".",
                  "Turn the picture of every face back; where an upload flips rows (flipY), switch that off.");
        else if (upright && o.mirrored())
            note("orientation",
                 std::string("The environment is mirrored in X") + (cube ? ": face +X shows the light from -X, and so on." : "."),
                 cube
                     ? "So three.js, PlayCanvas and Babylon.js (.dds) look cubes up. Where the plain world direction is looked up (OpenGL, "
                       "Filament), exchange faces +X and -X and mirror all six left to right, or negate x of the lookup."
                     : "Mirror the picture left to right, or negate x of the lookup.");
        else if (upright && ownAxes)
            note("orientation",
                 cube ? "The faces are unmirrored: a texel holds the light from its own direction (right-handed, +Y up), as Filament looks "
                        "cubes up."
                      : "The environment is not mirrored: +Z at the center, +X at the left, +Y up.");
        if (upright && std::abs(o.yaw) > 1e-9)
            fault("yaw", text("The environment is turned by %.4g degrees about +Y, from +Z towards +X.", o.yaw * 180.0 / pi),
                  text("Make the map again with the environment turned by %.4g degrees, or turn it in the engine.", -o.yaw * 180.0 / pi));
    }

    void curve()
    {
        if (d.transfer.transfer == Transfer::Linear)
            return;
        const std::string what(name(d.transfer.transfer));
        std::string cure = "Write radiance as it is: linear values, no display transform.";
        if (d.transfer.transfer == Transfer::SrgbEncoded)
            cure = "Decode the values from sRGB when loading (an sRGB texture), or write linear ones.";
        if (d.transfer.transfer == Transfer::SrgbDecoded)
            cure = "Values were linear already: load the source as linear, not as sRGB.";
        if (!isReversible(d.transfer.transfer))
            cure += " What the curve cut off is lost; start again from the probe.";
        fault("curve", "The values are " + what + (d.curveBeforeFiltering ? "; that was done before the levels were filtered." : "."),
              cure);
    }

    void clipping()
    {
        if (!d.clipping)
            return;
        const Clipping& c = *d.clipping;
        std::string what =
            c.texels > 0
                ? text("Level 0 ends at %.6g: %d texels should be brighter, with %.2g %% of the light.", c.value, c.texels, 100.0 * c.lost)
                : text("The light of a bright source is missing, as if the probe had been clipped near %.3g: %.2g %% of all light.",
                       c.value, 100.0 * c.lost);
        if (d.levels.size() > 1)
            what +=
                c.filtered ? " The levels were filtered from the clipped environment and lack it too." : " The filtered levels hold it.";
        const bool grave = c.lost > 5e-3 && (c.filtered || d.levels.size() == 1);
        std::string cure = c.filtered ? "Filter from the unclipped probe and clip only what is stored."
                                      : "A reflection of the sun is a little dim; the rough levels are right.";
        if (grave)
            fault("clipped", what, cure);
        else
            note("clipped", what, cure);
    }

    void scale()
    {
        if (!d.withProbe || std::abs(d.scale - 1.0) < energyTolerance ||
            (d.transfer.transfer != Transfer::Linear && !isReversible(d.transfer.transfer)))
            return;
        struct Known {
            double factor;
            const char *what, *cure;
        };
        constexpr std::array known{
            Known{pi, "pi: E where E/pi (radiance) is expected", "Divide by pi."},
            Known{1.0 / pi, "1/pi: divided by pi once too often", "Multiply by pi."},
            Known{2.0 * pi, "2 pi", "Divide by 2 pi."},
            Known{4.0 * pi, "4 pi: a sum over the sphere that was not normalized", "Divide by 4 pi."},
            Known{1.0 / (4.0 * pi), "1/(4 pi)", "Multiply by 4 pi."},
        };
        for (const Known& k : known)
            if (std::abs(d.scale / k.factor - 1.0) < energyTolerance) {
                fault("scale", text("Every level is too bright or dark by a factor of %.4g, that is ", d.scale) + k.what + ".", k.cure);
                return;
            }
        fault("scale", text("Every level is scaled by %.4g, that is %+.2f stops of exposure.", d.scale, std::log2(d.scale)),
              text("Set the exposure or intensity to %.4g, or write the map without it.", 1.0 / d.scale));
    }

    void law()
    {
        if (d.levels.size() < 2) {
            const LobeFit& fit = d.levels.front().fit;
            note("lobe", "The map shows " + lobeWords(d.levels.front()) + text(" (residual %.2g).", fit.residual));
            return;
        }
        std::vector<size_t> disorder;
        for (size_t l = 1; l < d.chain; ++l)
            if (std::sqrt(d.levels[l].fit.alpha) < std::sqrt(d.levels[l - 1].fit.alpha) - 0.05)
                disorder.push_back(l);
        const bool plain = std::all_of(d.levels.begin(), d.levels.end(), [](const LevelDiagnosis& level) {
            return level.fit.alpha < 1.5 * unresolvedAlpha(quarterTexels(level.layout)) || level.layout.size <= 2;
        });
        if (plain) {
            note("law", "No level is filtered by a lobe: these are plain halvings of the environment.",
                 "Good for a skybox. For reflections prefilter the levels: mirrorball filter --lobe ggx --mips.");
            return;
        }
        if (!disorder.empty())
            fault("order", "The levels are not blurred ever more: " + levelList(disorder) + " is sharper than the one before.",
                  "Check the order in which levels are written, and which level each roughness goes to.");
        if (d.lawFound()) {
            const LawFit& best = d.laws.front();
            std::string words = text("The roughness of the %zu levels follows %s", d.chain, best.formula.c_str()) + lawOwner(best) +
                                text(" (off by %.3f rms).", best.error);
            if (d.laws.size() > 1 && d.laws[1].error < 2.0 * best.error + 0.005)
                words += " " + d.laws[1].formula + lawOwner(d.laws[1]) + text(" fits about as well (%.3f).", d.laws[1].error);
            note("law", words, "Look roughness r up at the level where this rule has it.");
        } else if (disorder.empty()) {
            std::string list;
            for (size_t l = 0; l < d.chain; ++l)
                list += text("%s%.3f", l == 0 ? "" : " ", std::sqrt(d.levels[l].fit.alpha));
            fault("law",
                  "The roughness of the levels, " + list +
                      text(", follows no known rule; the nearest is %s", d.laws.front().formula.c_str()) + lawOwner(d.laws.front()) +
                      text(" (off by %.3f rms).", d.laws.front().error),
                  "Look up by these measured values, or filter again for the engine's rule.");
        }
        if (d.chain < d.levels.size())
            note("lobe", text("Level %zu is the diffuse light (E/pi), beside the chain.", d.levels.size() - 1));
    }
    static std::string lawOwner(const LawFit& law) { return law.owner.empty() ? "" : ", the rule of " + law.owner; }
    static std::string lobeWords(const LevelDiagnosis& level)
    {
        const LobeFit& fit = level.fit;
        if (fit.unfiltered)
            return "the environment unfiltered";
        if (fit.lobe.kind == LobeKind::Phong)
            return text("the environment through a Phong lobe of exponent %.4g", fit.lobe.exponent);
        if (fit.alpha > 0.97)
            return "the diffuse light (a ggx lobe of alpha 1 is the same)";
        return text("the environment through a ggx lobe of alpha %.4f, roughness %.3f", fit.alpha, std::sqrt(fit.alpha));
    }

    void engines()
    {
        if (!d.orientation || !d.orientation->certain() || !d.lawFound() || d.levels.size() < 2)
            return;
        const Orientation& o = *d.orientation;
        if (d.container == "playcanvas atlas" && o.storage.axes == glm::dmat3(1.0) && o.yaw == 0.0) {
            if (d.laws.front().name == name(RoughnessLaw::PlayCanvas))
                d.engines.emplace_back("PlayCanvas");
            note("engine", d.engines.empty() ? "So oriented is PlayCanvas' envAtlas, whose shader expects r = l/5."
                                             : "Orientation, layout and roughness rule are those that PlayCanvas' shader reads.");
        }
        if (d.kind != Parameterization::Cube)
            return;
        if (!o.strayFaces.empty() || o.restYaw != 0.0)
            return;
        std::string sameLaw, sameCube;
        for (const EngineProfile& profile : engineProfiles()) {
            if (!profile.law)
                continue;
            const bool atlas = std::any_of(profile.files.begin(), profile.files.end(),
                                           [](const EngineFile& file) { return file.content == EngineContent::Atlas; });
            const bool env = std::any_of(profile.files.begin(), profile.files.end(),
                                         [](const EngineFile& file) { return file.content == EngineContent::BabylonEnv; });
            if (atlas)
                continue;
            CubeOrientation stored = profile.cube;
            stored.bottomUp = env && d.container == "env"; // what the format itself asks for
            bool cube = true;
            for (const CubeStorage& storage : allCubeStorages())
                if (storage.axes == stored.axes && storage.turn == (stored.bottomUp ? rowsBottomUp : 0))
                    cube = storage.places == o.places;
            const bool law = name(*profile.law) == d.laws.front().name;
            const std::string title(profile.title);
            if (cube && law)
                d.engines.push_back(title);
            else if (law)
                sameLaw += (sameLaw.empty() ? "" : ", ") + title;
            else if (cube)
                sameCube += (sameCube.empty() ? "" : ", ") + title;
        }
        if (!d.engines.empty()) {
            std::string list;
            for (const std::string& engine : d.engines)
                list += (list.empty() ? "" : ", ") + engine;
            note("engine", "Orientation and roughness rule are those of " + list + ".");
        } else {
            note("engine",
                 std::string("No engine that is known takes this orientation together with this rule") +
                     (sameLaw.empty() ? "" : "; the rule is that of " + sameLaw + ", which stores its faces otherwise") +
                     (sameCube.empty() ? "" : "; so oriented are cubes of " + sameCube) + ".",
                 "Make it for one engine: mirrorball export --for ENGINE.");
        }
    }

    void levels()
    {
        if (std::any_of(d.levels.begin(), d.levels.end(),
                        [](const LevelDiagnosis& level) { return level.fit.lobe.kind == LobeKind::Phong; }))
            note("lobe", "Phong lobes fit clearly better than ggx in " +
                             levelList(levelsWhere([](const LevelDiagnosis& level) { return level.fit.lobe.kind == LobeKind::Phong; })) +
                             ".");
        const bool faulty =
            std::any_of(d.findings.begin(), d.findings.end(), [](const Finding& f) { return f.severity == Severity::Fault; });
        const auto energy = levelsWhere([](const LevelDiagnosis& level) {
            return level.layout.size > 1 && level.energy > 0.0 && std::abs(level.energy - 1.0) > 1.5 * energyTolerance;
        });
        if (!energy.empty() && !d.clipping) {
            std::string list;
            for (const size_t l : energy)
                list += text("%s%+.1f %%", list.empty() ? "" : ", ", 100.0 * (d.levels[l].energy - 1.0));
            fault("energy", "The mean light of " + levelList(energy) + " differs from the probe's: " + list + ".",
                  "A normalized filter keeps the mean; divide by the sum of the weights that were used.");
        }
        const auto seams = levelsWhere([&](const LevelDiagnosis& level) {
            return level.layout.size >= 4 && level.seam > 2.0 && level.seam > 1.6 * std::max(level.truthSeam, 1.0);
        });
        if (!seams.empty() && (!d.orientation || d.orientation->strayFaces.empty()))
            fault(
                "seam",
                text(
                    "Seams show in %s: the step over the edges of faces is up to %.1f times that inside.", levelList(seams).c_str(),
                    std::max_element(d.levels.begin(), d.levels.end(), [](const auto& a, const auto& b) { return a.seam < b.seam; })->seam),
                d.withProbe ? "Filter over the edges of faces, not each face by itself."
                            : "Faces may be turned or exchanged, or each was filtered by itself; --probe SOURCE tells which.");
        if (!d.withProbe || faulty)
            return;
        // A sharp level shows how its author averaged texels, which is no error.
        const auto wrong = levelsWhere([](const LevelDiagnosis& level) { return !sharp(level) && level.mended.relRms > errorWorthAFault; });
        if (!wrong.empty()) {
            std::string list;
            for (const size_t l : wrong)
                list += text("%s%.2g", list.empty() ? "" : ", ", d.levels[l].mended.relRms);
            fault("error", "rel_rms against the truth is " + list + " in " + levelList(wrong) + ", and no single cause explains it.",
                  "Check the source, the number of samples, and that both were made from the same probe.");
        }
    }
    static bool sharp(const LevelDiagnosis& level)
    {
        return level.fit.unfiltered || (level.asked && *level.asked < unresolvedAlpha(quarterTexels(level.layout)));
    }

    void shift()
    {
        if (!d.withProbe)
            return;
        std::vector<const LevelDiagnosis*> known;
        for (const LevelDiagnosis& level : d.levels)
            if (level.shift.known && level.mended.relRms < 0.5)
                known.push_back(&level);
        if (known.empty())
            return;
        // Half a texel in most levels is the place of the samples in their texels; anything else is said as it is.
        const auto share = [&](auto test) {
            return static_cast<double>(std::count_if(known.begin(), known.end(), [&](const LevelDiagnosis* l) { return test(l->shift); })) /
                   static_cast<double>(known.size());
        };
        const auto isHalf = [](double v) { return std::abs(std::abs(v) - 0.5) < 0.15; };
        const SampleShift& first = known.front()->shift;
        if (share([&](const SampleShift& s) {
                return (isHalf(s.right) || isHalf(s.down)) && (isHalf(s.right) || std::abs(s.right) < 0.15) &&
                       (isHalf(s.down) || std::abs(s.down) < 0.15);
            }) > 0.6) {
            fault("shift", text("Pictures lie half a texel off: %+.2f to the right, %+.2f down.", first.right, first.down),
                  "Directions were taken at the corners of texels; texel i of N has its center at (i + 1/2)/N.");
        } else if (share([](const SampleShift& s) { return std::abs(s.right) > 0.25 || std::abs(s.down) > 0.25; }) > 0.3) {
            std::string list;
            for (size_t l = 0; l < d.levels.size(); ++l)
                if (const SampleShift& s = d.levels[l].shift; s.known)
                    list += text("%s%+.2f %+.2f in level %zu", list.empty() ? "" : ", ", s.right, s.down, l);
            note("shift", "Pictures lie off by parts of a texel, to the right and down: " + list + ".",
                 "Look for nearest lookups and for sizes less one where the source is read.");
        }
        if (share([&](const SampleShift& s) { return isHalf(s.spread) && s.spread < 0.0; }) > 0.6)
            fault("shift",
                  text("The outermost texels lie on the edges of the pictures (off by %.2f texels there): edge-sampled.", -first.spread),
                  "Engines sample at centers: texel i of N stands at (i + 1/2)/N, not at i/(N - 1).");
        else if (share([&](const SampleShift& s) { return isHalf(s.spread) && s.spread > 0.0; }) > 0.6)
            fault("shift", text("The pictures reach %.2f texels beyond their edges, as for lookups that skip a border.", first.spread),
                  "Fill faces from edge to edge, texel i of N at (i + 1/2)/N.");
    }
};

} // namespace

bool Diagnosis::clean() const
{
    return std::none_of(findings.begin(), findings.end(), [](const Finding& f) { return f.severity == Severity::Fault; });
}

void concludeDiagnosis(Diagnosis& diagnosis) { Conclusion(diagnosis).run(); }

} // namespace mirrorball
