#include "brdf_errors.h"
#include "command.h"
#include "reading_options.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/filter/lookup_table.h"
#include "core/image/image_format.h"
#include "core/image/image_io.h"
#include "core/report/measured_domain.h"
#include "core/shading/brdf.h"
#include "core/shading/brdf_table.h"
#include "core/shading/reflectance_map.h"
#include "core/shading/reflection_kernel.h"

#include <charconv>
#include <cstdio>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string brdf, eval, table;
    std::vector<std::string> out;
    BrdfErrorsRequest errors;
    ReadingOptions reading;
    std::optional<int> albedo;
    std::optional<double> viewDeg;
    int size = 0;
    int threads = 0;
};

/// TI,PI,TO,PO in degrees.
std::array<double, 4> parseAngles(const std::string& text)
{
    std::array<double, 4> angles{};
    const char *at = text.data(), *end = at + text.size();
    for (size_t i = 0; i < 4; ++i) {
        const auto [next, error] = std::from_chars(at, end, angles[i]);
        const bool isLast = i == 3;
        if (error != std::errc() || (isLast ? next != end : next == end || *next != ','))
            throw InvalidArgument(
                "--eval: must be four angles in degrees, TI,PI,TO,PO: those of light and view from the normal and about it; "
                "it is '" +
                text + "'");
        at = next + 1;
    }
    for (const double polar : {angles[0], angles[2]})
        if (!(polar >= 0.0 && polar <= 180.0))
            throw InvalidArgument("--eval: the angles from the normal must lie from 0 to 180 degrees");
    return angles;
}

glm::dvec3 directionAt(double polarDeg, double azimuthDeg)
{
    const double t = radians(polarDeg), p = radians(azimuthDeg);
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

void print(const glm::dvec3& rgb) { std::printf("%.9g %.9g %.9g\n", rgb.r, rgb.g, rgb.b); }

/// What --table names.
struct TableChoice {
    std::optional<BrdfTable> byFormula{};
    std::optional<LookupChoice> lookups{};
    bool isMirrorMap = false;
    std::optional<double> hemisphereDeg{}, domainDeg{};
};

/// Degrees after "hemisphere:" or "domain:".
std::optional<double> incidenceOf(const std::string& word, const std::string& prefix)
{
    if (!word.starts_with(prefix))
        return std::nullopt;
    double angle = -1.0;
    const auto [end, error] = std::from_chars(word.data() + prefix.size(), word.data() + word.size(), angle);
    if (error != std::errc() || end != word.data() + word.size() || !(angle >= 0.0 && angle < 90.0))
        throw InvalidArgument("--table: " + prefix + " must be followed by an angle of at least 0 and below 90 degrees; it is '" + word +
                              "'");
    return angle;
}

TableChoice parseTable(const std::string& word)
{
    const TableChoice choice{.byFormula = brdfTableFromName(word),
                             .lookups = word == "lookups" ? LookupChoice{} : lookupChoiceFromWord(word),
                             .isMirrorMap = word == "mirror-map",
                             .hemisphereDeg = incidenceOf(word, "hemisphere:"),
                             .domainDeg = incidenceOf(word, "domain:")};
    if (!choice.byFormula && !choice.lookups && !choice.isMirrorMap && !choice.hemisphereDeg && !choice.domainDeg)
        throw InvalidArgument("--table: '" + word + "' is no table; choose one of " + brdfTableNames() +
                              ", mirror-map, hemisphere:DEG, domain:DEG, " + lookupChoiceHelp());
    return choice;
}

/// Refuses, before any work, what cannot be written.
void checkTable(const Options& o, const TableChoice& choice)
{
    const std::string& path = o.out.front();
    const ImageFormat& format = writableFormat(path);
    if (choice.domainDeg && format.samples != StoredSamples::Byte)
        throw InvalidArgument("--output: " + path + " holds linear light, and --table domain: is a picture; write a .png");
    checkTarget(path);
}

void writeTable(const Options& o, const TableChoice& choice, const Brdf& brdf)
{
    constexpr int usualMap = 256, domainEdge = 512;
    const std::string& path = o.out.front();
    const int edge = o.size > 0 ? o.size : usualMap;
    if (choice.hemisphereDeg) {
        const Image map = hemisphereMap(brdf, radians(*choice.hemisphereDeg), edge);
        if (writableFormat(path).samples == StoredSamples::Byte)
            writeImage(path, falseColored(map), {.encoding = Encoding::Display});
        else
            writeImage(path, map);
    } else if (choice.domainDeg) {
        const MeasuredBrdf* measured = std::get_if<MeasuredBrdf>(&brdf.model);
        if (!measured)
            throw InvalidArgument("--table: domain: shows where a file was measured; " + inQuotes(o.brdf) + " is a formula");
        writeImage(path, measuredDomainPicture(*measured, radians(*choice.domainDeg), o.size > 0 ? o.size : domainEdge),
                   {.encoding = Encoding::Display});
    } else if (choice.isMirrorMap) {
        writeImage(path, mirrorReflectanceMap(brdf, edge), {.bytes = ByteEncoding::Srgb});
    } else if (choice.lookups) {
        writeImage(path, makeLookupTable(brdf, *choice.lookups, o.size, jobWithProgress("brdf", o.threads)));
    } else {
        writeImage(path, makeBrdfTable(brdf, *choice.byFormula, o.size, jobWithProgress("brdf", o.threads)));
    }
}

/// Refuses what does not go together, before any work.
void check(const Options& o)
{
    const int asked = !o.eval.empty() + (o.albedo || o.viewDeg ? 1 : 0) + !o.table.empty() + !o.errors.probe.empty();
    if (asked != 1)
        throw InvalidArgument("brdf: give one of --eval, --albedo (or --view), --table and --errors");
    if (!o.table.empty() && o.out.size() != 1)
        throw InvalidArgument(o.out.empty() ? "--output: is missing; --table writes a file" : "--output: --table writes one file");
    if (o.table.empty() && o.errors.probe.empty() && !o.out.empty())
        throw InvalidArgument("--output: belongs to --table and --errors");
    if (o.errors.probe.empty() && !(o.errors.views.empty() && o.errors.lookups.empty()))
        throw InvalidArgument("--views, --lookups: belong to --errors");
    if (o.albedo && o.viewDeg)
        throw InvalidArgument("--view: is one angle, --albedo a row of them; give one");
    if (o.viewDeg && !(*o.viewDeg >= 0.0 && *o.viewDeg < 90.0))
        throw InvalidArgument("--view: must be an angle of at least 0 and below 90 degrees");
    if (o.albedo && !(*o.albedo >= 1 && *o.albedo <= 4096))
        throw InvalidArgument("--albedo: must be a whole number of angles from 1 to 4096");
}

void run(const Options& o)
{
    check(o);
    const TableChoice table = o.table.empty() ? TableChoice{} : parseTable(o.table);
    if (!o.table.empty())
        checkTable(o, table);
    const std::array<double, 4> angles = o.eval.empty() ? std::array<double, 4>{} : parseAngles(o.eval);
    BrdfErrorsRequest errors = o.errors;
    errors.out = o.out;
    errors.threads = o.threads;
    errors.reading = o.reading.parse();
    if (!errors.probe.empty())
        checkBrdfErrors(errors);

    const Brdf brdf = brdfFromText(o.brdf);
    if (const auto* measured = std::get_if<MeasuredBrdf>(&brdf.model); measured && measured->gaps().holes + measured->gaps().clamped > 0)
        std::fprintf(stderr, "mirrorball: %s: of %zu values %zu were holes and are filled from their neighbors, %zu lie outside Rec.709\n",
                     measured->name().c_str(), measured->gaps().samples, measured->gaps().holes, measured->gaps().clamped);
    if (!o.eval.empty()) {
        print(evaluate(brdf, directionAt(angles[0], angles[1]), directionAt(angles[2], angles[3])));
    } else if (o.viewDeg) {
        print(directionalAlbedo(brdf, radians(*o.viewDeg)));
    } else if (o.albedo) {
        for (int i = 0; i < *o.albedo; ++i) {
            const double deg = *o.albedo == 1 ? 0.0 : 89.0 * i / (*o.albedo - 1);
            std::printf("%.6g ", deg);
            print(directionalAlbedo(brdf, radians(deg)));
        }
    } else if (!errors.probe.empty()) {
        printBrdfErrors(errors, brdf);
    } else {
        writeTable(o, table, brdf);
    }
}

} // namespace

void addBrdfCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command =
        program.add_subcommand("brdf", "Values, directional albedo and tables of a reflection model or a measured material");
    command
        ->add_option("BRDF", o->brdf,
                     "phong:exponent=N, lafortune:exponent=N[,cxy=,cz=,weight=][/...], ward:alpha=A, cook-torrance:m=M, "
                     "beckmann:alpha=A or ggx:alpha=A, each with ior=N, f0=R or metal=NAME beside it; or a measured file (.binary, "
                     ".brdf, .csv, .txt)")
        ->required();
    command->add_option("--eval", o->eval, "TI,PI,TO,PO: print f as R G B, in 1/sr, for these angles of light and view, in degrees");
    command->add_option("--albedo", o->albedo, "print the directional albedo at so many angles of view from 0 to 89 degrees: angle R G B");
    command->add_option("--view", o->viewDeg, "print the directional albedo at this angle of view, in degrees: R G B");
    command->add_option(
        "--table", o->table,
        "write a table: " + brdfTableHelp() +
            "; lookups:K (axis, width and weight of K lookups over n.v), or those of split-sum, three, filament; or draw mirror-map "
            "(reflectance as a sphere map), hemisphere:DEG (where light from there goes), domain:DEG (where a file was "
            "measured for it)");
    command->add_option(
        "--errors", o->errors.probe,
        "PROBE: print what lookups miss of the material in this light, rel_rms against the sum over every texel by angle of "
        "view; an image file, or builtin:NAME");
    command->add_option("--lookups", o->errors.lookups,
                        "errors: which, comma-separated: " + lookupChoiceHelp() + " (default: 5,3,split-sum,three,filament)");
    command->add_option("--views", o->errors.views, "errors: angles of view in degrees, comma-separated (default: 0,15,30,45,60,75)");
    command->add_option("--height", o->errors.height, "errors: rows of the latlong that a larger probe is averaged to first")
        ->check(CLI::Range(8, 1024));
    o->reading.addTo(*command);
    command->add_option("--size", o->size, "table: entries along n.v, or texels of a map's edge (0: as many as it needs)")
        ->check(CLI::Range(0, 4096));
    command
        ->add_option(
            "-o,--output", o->out,
            "table: output file (.exr, .hdr, .tif, maps .png, too); errors: the same as .csv, .json or a plot (.png), once for each")
        ->allow_extra_args(false);
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(CLI::Range(0, 1024));
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
