#include "arrays.h"
#include "module.h"
#include "reading.h"
#include "work.h"

#include "core/base/error.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/image/probe_file.h"
#include "core/image/reproject.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <memory>

namespace py = pybind11;

namespace mirrorball::python {

namespace {

using Map = std::shared_ptr<EnvironmentMap>;

constexpr double radiansOf(double degrees) { return degrees * pi / 180.0; }

/// The size that a picture of a kind has. @throws InvalidArgument when it is no picture of that kind
Map mapOf(const std::string& kind, const py::object& texels, int border)
{
    Image image = toImage(toNumbers(texels, "texels"), "texels");
    if (image.channels != 3)
        throw InvalidArgument("texels: must have 3 channels; it has " + std::to_string(image.channels));
    const Parameterization p = toKind(kind, "kind");
    const bool isWide = mapping(p).columns > mapping(p).rows;
    const MapLayout layout = toLayout(kind, isWide ? image.height : image.width, border);
    if (layout.width() != image.width || layout.height() != image.height)
        throw InvalidArgument("texels: a " + kind + " map of size " + std::to_string(layout.size) + " has the shape [" +
                              std::to_string(layout.height()) + ", " + std::to_string(layout.width()) + ", 3]; it is [" +
                              std::to_string(image.height) + ", " + std::to_string(image.width) + ", 3]");
    return std::make_shared<EnvironmentMap>(layout, std::move(image));
}

template <typename Float>
py::array_t<float> radianceAt(const EnvironmentMap& map, const py::array& array)
{
    const auto shape = shapeOfVectors(array, "directions");
    const auto directions = py::array_t<Float, py::array::c_style | py::array::forcecast>::ensure(array);
    py::array_t<float> radiance(shape);
    const Float* d = directions.data();
    float* out = radiance.mutable_data();
    const py::ssize_t count = directions.size() / 3;
    const py::gil_scoped_release released;
    for (py::ssize_t i = 0; i < count; ++i, d += 3, out += 3) {
        const glm::vec3 rgb = map.radiance(glm::dvec3(d[0], d[1], d[2]));
        std::copy_n(&rgb.x, 3, out);
    }
    return radiance;
}

/// `fill(x, y)` of every texel of a layout, as [height, width, n].
py::array_t<double> directionsOf(const MapLayout& layout)
{
    py::array_t<double> array({layout.height(), layout.width(), 3});
    double* out = array.mutable_data();
    for (int y = 0; y < layout.height(); ++y)
        for (int x = 0; x < layout.width(); ++x, out += 3) {
            const glm::dvec3 d = texelDirection(layout, x, y);
            std::copy_n(&d.x, 3, out);
        }
    return array;
}

py::array_t<double> solidAnglesOf(const MapLayout& layout)
{
    const SolidAngles angles(layout);
    py::array_t<double> array({layout.height(), layout.width()});
    double* out = array.mutable_data();
    for (int y = 0; y < layout.height(); ++y)
        for (int x = 0; x < layout.width(); ++x)
            *out++ = angles.at(x, y);
    return array;
}

std::string describeMap(const EnvironmentMap& map)
{
    return "<mirrorball.EnvironmentMap " + std::string(name(map.layout.kind)) + " " + std::to_string(map.layout.size) + ">";
}

void bindMap(py::module_& m)
{
    py::class_<EnvironmentMap, Map>(m, "EnvironmentMap", py::buffer_protocol(),
                                    "Radiance by direction: linear RGB texels and the layout that says what direction each stands for.")
        .def(py::init(&mapOf), py::arg("kind"), py::arg("texels"), py::kw_only(), py::arg("border") = 0,
             "A map from texels [height, width, 3], row 0 on top: latlong [N, 2N], cube [6N, N] with faces +X -X +Y -Y +Z -Z, sphere, "
             "angular and octahedral [N, N], paraboloid [N, 2N]. They are copied once.")
        .def_static(
            "empty",
            [](const std::string& kind, int size, int border) { return std::make_shared<EnvironmentMap>(toLayout(kind, size, border)); },
            py::arg("kind"), py::arg("size"), py::kw_only(), py::arg("border") = 0,
            "A black map to be filled through `texels`, without a copy.")
        .def_property_readonly("kind", [](const EnvironmentMap& map) { return std::string(name(map.layout.kind)); })
        .def_property_readonly(
            "size", [](const EnvironmentMap& map) { return map.layout.size; }, "N: face edge, disc edge, latlong height")
        .def_property_readonly("border", [](const EnvironmentMap& map) { return map.layout.border; })
        .def_property_readonly("width", [](const EnvironmentMap& map) { return map.image.width; })
        .def_property_readonly("height", [](const EnvironmentMap& map) { return map.image.height; })
        .def_property_readonly(
            "texels", [](const py::object& self) { return viewOf(self.cast<EnvironmentMap&>().image, self); },
            "float32 [height, width, 3]: the map's own memory, to be read and written")
        .def(
            "radiance",
            [](const EnvironmentMap& map, const py::object& thing) {
                const py::array directions = toNumbers(thing, "directions");
                return py::isinstance<py::array_t<float>>(directions) ? radianceAt<float>(map, directions)
                                                                      : radianceAt<double>(map, directions);
            },
            py::arg("directions"),
            "Bilinear, seamless lookups: directions [..., 3], of any length -> float32 [..., 3]. +Y is up, +Z the middle of a latlong.")
        .def(
            "directions", [](const EnvironmentMap& map) { return directionsOf(map.layout); },
            "float64 [height, width, 3]: unit vectors of the texels' centers")
        .def(
            "solid_angles", [](const EnvironmentMap& map) { return solidAnglesOf(map.layout); },
            "float64 [height, width]: steradians of each texel, 0 outside a disc; their sum is 4 pi")
        .def(
            "mean_radiance",
            [](const EnvironmentMap& map) {
                const glm::dvec3 mean = meanRadiance(map);
                return py::make_tuple(mean.r, mean.g, mean.b);
            },
            "RGB, weighted by solid angle")
        .def("__eq__", [](const EnvironmentMap& a, const EnvironmentMap& b) { return a.layout == b.layout && a.image == b.image; })
        .def("__eq__", [](const EnvironmentMap&, const py::object&) { return false; })
        .def("__repr__", &describeMap)
        .def_buffer([](EnvironmentMap& map) {
            const auto width = static_cast<py::ssize_t>(map.image.width), height = static_cast<py::ssize_t>(map.image.height);
            constexpr auto bytes = static_cast<py::ssize_t>(sizeof(float));
            return py::buffer_info(map.image.texels.data(), bytes, py::format_descriptor<float>::format(), 3,
                                   {height, width, py::ssize_t{3}}, {3 * width * bytes, 3 * bytes, bytes});
        });
}

/// A probe as read: its map, and what was found.
struct ReadResult {
    Map map{};
    Probe probe{}; ///< its map is moved out
};

ReadResult read(const std::filesystem::path& path, const std::optional<std::string>& kind, const std::string& negatives, int threads,
                const py::object& progress, const py::kwargs& reading)
{
    ReadProbeOptions options{.reading = toReading("read_probe", reading)};
    if (kind)
        options.reading.parameterization = toKind(*kind, "kind");
    if (negatives != "keep" && negatives != "clamp")
        throw InvalidArgument("negatives: '" + negatives + "' is neither keep nor clamp");
    options.negatives = negatives == "clamp" ? NegativePolicy::Clamp : NegativePolicy::Keep;
    ReadResult result;
    result.probe = resultOf(threads, progress, [&](const JobControl& job) { return readProbe(path.string(), options, job); });
    result.map = std::make_shared<EnvironmentMap>(std::move(result.probe.map));
    return result;
}

void bindProbe(py::module_& m)
{
    py::class_<ReadResult>(m, "Probe", "A light probe as it was read.")
        .def_readonly("map", &ReadResult::map)
        .def_property_readonly(
            "origin", [](const ReadResult& r) { return r.probe.origin; }, "how the parameterization was found, in words")
        .def_property_readonly(
            "certain", [](const ReadResult& r) { return r.probe.certain; }, "False: a guess by shape alone")
        .def_property_readonly(
            "repaired", [](const ReadResult& r) { return describe(r.probe.repaired); },
            "what was not finite or below 0, and what became of it")
        .def_property_readonly(
            "notes", [](const ReadResult& r) { return r.probe.notes; }, "what of the file a user should know, a clause each");
    m.def("read_probe", &read, py::arg("path"), py::arg("kind") = py::none(), py::kw_only(), py::arg("negatives") = "keep",
          py::arg("threads") = 0, py::arg("progress") = py::none(),
          withReadingHelp("Reads a probe, a file or builtin:NAME. `negatives` are kept, or clamped to 0: keep or clamp.").c_str());
}

std::vector<std::filesystem::path> write(const std::filesystem::path& path, const std::vector<EnvironmentMap>& levels, bool half,
                                         const std::map<std::string, std::string>& attributes)
{
    checkMapFile(path, levels.front().layout);
    const WriteOptions options{.sampleType = half ? SampleType::Half : SampleType::Float, .attributes = attributes};
    const py::gil_scoped_release released;
    return writeMap(path, levels, options);
}

} // namespace

void bindMaps(py::module_& m)
{
    bindMap(m);
    bindProbe(m);
    m.def(
        "reproject",
        [](const EnvironmentMap& map, const std::string& to, int size, double yaw, int border, int threads, const py::object& progress) {
            const ReprojectOptions options{.target = toLayout(to, size, border), .yaw = radiansOf(yaw)};
            return std::make_shared<EnvironmentMap>(
                resultOf(threads, progress, [&](const JobControl& job) { return reproject(map, options, job); }));
        },
        py::arg("map"), py::arg("to"), py::arg("size"), py::kw_only(), py::arg("yaw") = 0.0, py::arg("border") = 0, py::arg("threads") = 0,
        py::arg("progress") = py::none(), "Resamples a map to another parameterization, size or yaw (degrees about +Y).");
    m.def(
        "mip_levels",
        [](const EnvironmentMap& map, int threads) {
            std::vector<EnvironmentMap> levels =
                resultOf(threads, py::none(), [&](const JobControl& job) { return buildMipPyramid(map, job).levels; });
            std::vector<Map> shared;
            for (EnvironmentMap& level : levels)
                shared.push_back(std::make_shared<EnvironmentMap>(std::move(level)));
            return shared;
        },
        py::arg("map"), py::kw_only(), py::arg("threads") = 0, "The map and its halvings, filtered across seams, down to one texel.");
    m.def(
        "write_map",
        [](const std::filesystem::path& path, const EnvironmentMap& map, bool half, const std::map<std::string, std::string>& attributes) {
            return write(path, {map}, half, attributes);
        },
        py::arg("path"), py::arg("map"), py::kw_only(), py::arg("half") = false,
        py::arg("attributes") = std::map<std::string, std::string>{},
        "Writes a map; %s in the name of a cube makes six files. Returns the paths written. Files appear whole or not at all.");
    m.def(
        "write_map",
        [](const std::filesystem::path& path, const std::vector<Map>& maps, bool half,
           const std::map<std::string, std::string>& attributes) {
            if (maps.empty())
                throw InvalidArgument("map: is an empty list; give one level at least");
            std::vector<EnvironmentMap> levels;
            for (const Map& map : maps)
                levels.push_back(*map);
            return write(path, levels, half, attributes);
        },
        py::arg("path"), py::arg("map"), py::kw_only(), py::arg("half") = false,
        py::arg("attributes") = std::map<std::string, std::string>{}, "The same for a chain of levels, largest first.");
}

} // namespace mirrorball::python
