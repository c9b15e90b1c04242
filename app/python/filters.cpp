#include "arrays.h"
#include "module.h"
#include "reading.h"
#include "work.h"

#include "core/base/error.h"
#include "core/engine/filter_chain.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/preview/paraboloid_blur.h"
#include "core/report/lobe_words.h"
#include "core/scene/file_filter.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <mutex>

namespace py = pybind11;

namespace mirrorball::python {

namespace {

void bindLobe(py::module_& m)
{
    py::class_<Lobe>(m, "Lobe", "A radially symmetric kernel about the lookup direction, integral 1 over the sphere.")
        .def_static("phong", &phongLobe, py::arg("exponent"), "k = (n+1)/(2 pi) max(cos t, 0)^n, looked up by reflection")
        .def_static("diffuse", &diffuseLobe, "k = max(cos t, 0)/pi, looked up by normal")
        .def_static("ggx", &ggxLobe, py::arg("alpha"), "the split sum's prefilter, N = V = R; alpha = roughness^2 in [0, 1], 0 is a mirror")
        .def_static("tabulated", &tabulatedLobe, py::arg("samples"),
                    "linear between samples equally spaced in cos t over [0, 1]; scaled to integral 1")
        .def_static("parse", &lobeFromWord, py::arg("word"), "from phong:EXPONENT, ggx:ALPHA or diffuse")
        .def(
            "evaluate",
            [](const Lobe& lobe, py::array_t<double, py::array::forcecast> cosine) {
                const LobeShape shape(lobe);
                return py::vectorize([&](double c) { return shape.relative(c) / shape.integral(); })(std::move(cosine));
            },
            py::arg("cosine"), "k in 1/sr at cosines of the angle from the axis, any shape")
        .def(
            "legendre",
            [](const Lobe& lobe, int bandLimit) {
                if (bandLimit < 0 || bandLimit > (1 << 16))
                    throw InvalidArgument("band_limit: must lie in 0 to 65536; it is " + std::to_string(bandLimit));
                return py::array_t<double>(py::cast(legendreCoefficients(lobe, bandLimit)));
            },
            py::arg("band_limit"), "k_l for l = 0 .. band_limit, float64 [band_limit + 1]: the factors of a radial convolution; k_0 = 1")
        .def("__eq__", [](const Lobe& a, const Lobe& b) { return a == b; })
        .def("__eq__", [](const Lobe&, const py::object&) { return false; })
        .def("__repr__", [](const Lobe& lobe) { return "<mirrorball.Lobe " + describe(lobe) + ">"; });
}

/// A probe made ready, whose spectrum every further filter shares.
struct Source {
    explicit Source(std::shared_ptr<EnvironmentMap> map_) : map(std::move(map_)) {}
    std::shared_ptr<EnvironmentMap> map;
    std::mutex working{}; ///< a FilterSource is for one thread at a time
    SceneProbe probe{};
};

/// What came of a filter: its levels, and how they were made.
struct Filtered {
    std::shared_ptr<std::vector<EnvironmentMap>> levels{};
    std::vector<PrefilterOptions> options{};
    WorkRecord record{};

    /// A level as an object of its own that shares the memory of all.
    std::shared_ptr<EnvironmentMap> level(size_t i) const { return {levels, &(*levels)[i]}; }
};

struct FilterArguments {
    std::optional<Lobe> lobe{};
    std::optional<RoughnessLaw> law{};
    PrefilterOptions first{}; ///< but for its yaw
    double yawDeg = 0.0;
    int levels = 1;

    std::vector<PrefilterOptions> jobs() const
    {
        PrefilterOptions turned = first;
        turned.yaw = yawDeg * pi / 180.0;
        return filterChain(turned, lobe, law, levels);
    }
};

Filtered filterFile(const std::string& probe, const ProbeReading& reading, const FilterArguments& arguments, int threads,
                    const py::object& progress)
{
    Filtered result{.options = arguments.jobs()};
    result.levels = resultOf(threads, progress, [&](const JobControl& job) {
        PlannedFileFilter planned = planFileFilter(
            {.probe = probe, .read = {.reading = reading}, .levels = result.options, .device = std::make_shared<preview::ParaboloidBlur>()},
            job);
        BuiltMap built = mirrorball::filterFile(std::move(planned), job);
        result.record = std::move(built.record);
        return std::make_shared<std::vector<EnvironmentMap>>(std::move(built.levels));
    });
    return result;
}

Filtered filterSource(Source& source, const FilterArguments& arguments, int threads, const py::object& progress)
{
    Filtered result{.options = arguments.jobs()};
    result.levels = resultOf(threads, progress, [&](const JobControl& job) {
        const std::lock_guard lock(source.working);
        if (!source.probe.source) {
            source.probe.source.emplace(*source.map, job);
            source.probe.source->useParaboloidDevice(std::make_shared<preview::ParaboloidBlur>());
        }
        const Plan plan = planFilters("the map", source.map->layout, result.options, "");
        BuiltMap built = buildMap(plan.exports.front().map, source.probe, 0.0, job);
        result.record = std::move(built.record);
        return std::make_shared<std::vector<EnvironmentMap>>(std::move(built.levels));
    });
    return result;
}

FilterArguments arguments(const py::object& lobe, const std::string& to, int size, double yaw, int border, const std::string& method,
                          double tolerance, bool mips, const std::optional<std::string>& law, std::optional<int> levels,
                          const std::optional<int>& samples, const std::optional<double>& lambda)
{
    FilterArguments a;
    const auto known = methodFromName(method);
    if (!known)
        throw InvalidArgument("method: '" + method + "' is no method");
    if (!(tolerance > 0.0 && tolerance <= 1.0))
        throw InvalidArgument("tolerance: must lie in (0, 1]");
    const auto checkKnob = [&](bool isGiven, const std::string& argument, std::string_view knob) {
        if (isGiven && !hasKnob(*known, knob))
            throw InvalidArgument(argument + ": belongs to the method " + ownersOf(knob) + ", not to '" + method + "'");
    };
    checkKnob(samples.has_value(), "samples", "samples");
    checkKnob(lambda.has_value(), "lambda_", "lambda");
    if (samples && (*samples < 1 || *samples > (1 << 20)))
        throw InvalidArgument("samples: must lie in 1 to 1048576");
    if (py::isinstance<py::str>(lobe))
        a.lobe = lobeFromWord(lobe.cast<std::string>());
    else if (py::isinstance<Lobe>(lobe))
        a.lobe = lobe.cast<Lobe>();
    else if (!lobe.is_none())
        throw py::type_error("lobe: must be a Lobe, a word such as \"phong:50\", or None");
    if (law)
        a.law = lawOfEngine(*law, "law");
    if (law && a.lobe)
        throw InvalidArgument("law: says the lobe of every level; leave lobe out");
    if (!law && !a.lobe && !mips)
        throw InvalidArgument("lobe: is missing; give one, or mips=True for a ggx chain, or law");
    if (levels && !law)
        throw InvalidArgument("levels: belongs to law, whose chain it counts");
    a.first.target = toLayout(to, size, border);
    a.first.method = *known;
    a.first.tolerance = tolerance;
    a.yawDeg = yaw;
    a.first.knobs.lambda = lambda;
    if (samples)
        a.first.knobs.samples = *samples;
    a.levels = law || mips ? levels.value_or(levelCount(a.first.target)) : 1;
    return a;
}

py::list stagesOf(const std::vector<Stage>& stages)
{
    py::list list;
    for (const Stage& stage : stages)
        list.append(py::dict(py::arg("name") = stage.name, py::arg("seconds") = stage.seconds, py::arg("left_out") = stage.leftOut,
                             py::arg("why") = stage.why));
    return list;
}

void bindResult(py::module_& m)
{
    py::class_<Filtered>(m, "FilteredMap", "A prefiltered map: a level, or a chain of them, and how they were made.")
        .def_property_readonly(
            "map", [](const Filtered& f) { return f.level(0); }, "the largest level")
        .def_property_readonly(
            "levels",
            [](const Filtered& f) {
                std::vector<std::shared_ptr<EnvironmentMap>> levels;
                for (size_t i = 0; i < f.levels->size(); ++i)
                    levels.push_back(f.level(i));
                return levels;
            },
            "all of them, largest first")
        .def_property_readonly(
            "lobes",
            [](const Filtered& f) {
                std::vector<std::string> lobes;
                for (const PrefilterOptions& level : f.options)
                    lobes.push_back(describe(level.lobe));
                return lobes;
            },
            "a word a level: phong:50, ggx:0.09")
        .def_property_readonly(
            "method", [](const Filtered& f) { return f.record.methodText(); }, "the methods that ran")
        .def_property_readonly(
            "band_limit", [](const Filtered& f) { return f.record.bandLimit; }, "spectral only; the largest")
        .def_property_readonly(
            "predicted_error", [](const Filtered& f) { return f.record.predicted.relRms; }, "rel_rms; the largest")
        .def_property_readonly(
            "predicted_median_rel", [](const Filtered& f) { return f.record.predicted.medianRel; }, "the largest")
        .def_property_readonly(
            "predicted_p99_rel", [](const Filtered& f) { return f.record.predicted.p99Rel; }, "the largest")
        .def_property_readonly(
            "promised", [](const Filtered& f) { return f.record.unpromised.empty(); }, "whether every level keeps the tolerance")
        .def_property_readonly(
            "notes", [](const Filtered& f) { return f.record.notes; }, "what of the probe's file a user should know, a clause each")
        .def_property_readonly(
            "stages", [](const Filtered& f) { return stagesOf(f.record.stages); }, "what was done: dicts of name, seconds, left_out, why")
        .def(
            "write",
            [](const Filtered& f, const std::filesystem::path& path, bool half) {
                checkMapFile(path, f.levels->front().layout);
                const WriteOptions options{.sampleType = half ? SampleType::Half : SampleType::Float,
                                           .attributes = filterAttributes(f.options)};
                const py::gil_scoped_release released;
                return writeMap(path, *f.levels, options);
            },
            py::arg("path"), py::kw_only(), py::arg("half") = false,
            "Writes the levels as `mirrorball filter` does, the same bytes. Returns the paths written.");
}

/// `prefilter` for one kind of input, which `run` takes; `More` are its own arguments, behind those that all kinds have.
template <typename Input, typename... More, typename Run>
void bindPrefilter(py::module_& m, const char* input, const std::string& text, Run&& run)
{
    m.def(
        "prefilter",
        [run](Input probe, const py::object& lobe, const std::string& to, int size, double yaw, int border, const std::string& method,
              double tolerance, bool mips, const std::optional<std::string>& law, std::optional<int> levels,
              const std::optional<int>& samples, const std::optional<double>& lambda, int threads, const py::object& progress,
              const More&... more) {
            return run(probe, arguments(lobe, to, size, yaw, border, method, tolerance, mips, law, levels, samples, lambda), threads,
                       progress, more...);
        },
        py::arg(input), py::arg("lobe") = py::none(), py::kw_only(), py::arg("to") = "cube", py::arg("size") = 128, py::arg("yaw") = 0.0,
        py::arg("border") = 0, py::arg("method") = "auto", py::arg("tolerance") = 1e-5, py::arg("mips") = false,
        py::arg("law") = py::none(), py::arg("levels") = py::none(), py::arg("samples") = py::none(), py::arg("lambda_") = py::none(),
        py::arg("threads") = 0, py::arg("progress") = py::none(), text.c_str());
}

} // namespace

void bindFilters(py::module_& m)
{
    bindLobe(m);
    py::class_<Source, std::shared_ptr<Source>>(
        m, "Source",
        "A map made ready for many filters: its spectrum is computed once and shared. Filters through one wait for each other.")
        .def(py::init<std::shared_ptr<EnvironmentMap>>(), py::arg("map"))
        .def_readonly("map", &Source::map);
    bindResult(m);
    bindPrefilter<std::shared_ptr<Source>>(m, "source", "Filters a source with a lobe; see the module's documentation.",
                                           [](const std::shared_ptr<Source>& source, const FilterArguments& a, int threads,
                                              const py::object& progress) { return filterSource(*source, a, threads, progress); });
    bindPrefilter<std::shared_ptr<EnvironmentMap>>(
        m, "map", "Filters a map with a lobe.",
        [](const std::shared_ptr<EnvironmentMap>& map, const FilterArguments& a, int threads, const py::object& progress) {
            Source once(map);
            return filterSource(once, a, threads, progress);
        });
    bindPrefilter<std::filesystem::path, py::kwargs>(
        m, "probe",
        withReadingHelp(
            "Filters a probe's file, streamed where it is too large to hold; or the file of a spectrum, which takes none of the "
            "keywords below."),
        [](const std::filesystem::path& probe, FilterArguments a, int threads, const py::object& progress, const py::kwargs& keywords) {
            const ReadingAndYaw apart = yawApart(toReading("prefilter", keywords));
            a.yawDeg += apart.yawDeg;
            return filterFile(probe.string(), apart.reading, a, threads, progress);
        });
}

} // namespace mirrorball::python
