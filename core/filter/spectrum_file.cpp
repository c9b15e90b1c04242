#include "spectrum_file.h"

#include "spectral.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/field_json.h"
#include "core/base/file_log.h"
#include "core/image/image_format.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <span>
#include <utility>

namespace mirrorball {

namespace {

using Complex = std::complex<double>;

constexpr std::string_view firstLine = "mirrorball spectrum 1\n";
constexpr size_t longestHeader = size_t{1} << 20;
constexpr int largestSide = 1 << 17;
constexpr int mostParts = 1 << 16;
static_assert(std::endian::native == std::endian::little, "the numbers of the file are written as they are in memory");

/// A range of rows as the header has it.
struct HeaderRows {
    int first = 0, end = 0;
    UnknownKeys unknown{};

    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"first", "first row", 0, largestSide}, self.first);
        visit(Field{"end", "row behind the last", 1, largestSide}, self.end);
    }
};

/// Everything of a part but its long lists.
struct Header {
    int width = 0, height = 0, degree = 0, bright = 0;
    double threshold = 0.0, peak = 0.0, least = 0.0;
    glm::dvec3 secondMoment{0.0};
    double nan = 0, positiveInfinity = 0, negativeInfinity = 0, negative = 0, clamped = 0;
    std::string probe{};
    std::vector<HeaderRows> rows{};

    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        constexpr double most = 1e18;
        visit(Field{"width", "columns of the probe", 2, largestSide}, self.width);
        visit(Field{"height", "rows of the probe", 1, largestSide}, self.height);
        visit(Field{"degree", "band limit", 1, largestBandLimit}, self.degree);
        visit(Field{"bright", "texels that were taken out", 0, 1 << 26}, self.bright);
        visit(Field{"threshold", "largest channel of a texel that stays; 0: none was taken out", 0, 1e30}, self.threshold);
        visit(Field{"peak", "largest texel of what is left", 0, 1e38}, self.peak);
        visit(Field{"least", "smallest texel", -1e38, 1e38}, self.least);
        visit(Field{"second_moment", "integral of the square of what is left", 0, 1e78}, self.secondMoment);
        visit(Field{"nan", "repaired", 0, most}, self.nan);
        visit(Field{"positive_infinity", "repaired", 0, most}, self.positiveInfinity);
        visit(Field{"negative_infinity", "repaired", 0, most}, self.negativeInfinity);
        visit(Field{"negative", "values below 0", 0, most}, self.negative);
        visit(Field{"clamped", "those of them that were set to 0", 0, most}, self.clamped);
        visit(Field{"probe", "the probe's name"}, self.probe);
        visit(Field{"rows", "rows that are there", 1, mostParts}, self.rows);
    }
};

size_t coefficientCount(int degree) { return static_cast<size_t>(degree + 1) * static_cast<size_t>(degree + 2) / 2; }

/// Numbers of a bright texel: x, y, before, calm.
constexpr size_t numbersOfBright = 8;

Header headerOf(const SpectrumPart& part)
{
    const Spectrum& s = part.calm;
    const RepairReport& r = part.repaired;
    Header header{.width = s.ringLength,
                  .height = s.rings,
                  .degree = s.bandLimit,
                  .bright = static_cast<int>(part.bright.changes.size()),
                  .threshold = part.threshold,
                  .peak = s.peak,
                  .least = s.least,
                  .secondMoment = s.secondMoment,
                  .nan = static_cast<double>(r.nan),
                  .positiveInfinity = static_cast<double>(r.positiveInfinity),
                  .negativeInfinity = static_cast<double>(r.negativeInfinity),
                  .negative = static_cast<double>(r.negative),
                  .clamped = static_cast<double>(r.clamped),
                  .probe = part.probe};
    for (const RowRange& rows : part.rows)
        header.rows.push_back({.first = rows.first, .end = rows.end});
    return header;
}

/// Adds a texel to what was taken out.
void take(BrightTexels& bright, const MapLayout& layout, const BrightTexels::Change& change)
{
    bright.directions.push_back(texelDirection(layout, change.x, change.y));
    bright.flux.push_back((change.before - change.calm) * texelSolidAngle(layout, change.x, change.y));
    bright.energy += bright.flux.back();
    bright.squares += bright.flux.back() * (change.before + change.calm);
    bright.changes.push_back(change);
}

/// Brings the texels above the threshold in a block of rows down to it, and remembers them.
void takeBright(float* rgb, const MapLayout& layout, int firstRow, int rows, double threshold, BrightTexels& bright)
{
    for (int y = firstRow; y < firstRow + rows; ++y)
        for (int x = 0; x < layout.width(); ++x, rgb += 3) {
            const double largest = std::max({rgb[0], rgb[1], rgb[2]});
            if (!(largest > threshold))
                continue;
            BrightTexels::Change change{.x = x, .y = y, .before = {rgb[0], rgb[1], rgb[2]}, .calm = glm::dvec3(0.0)};
            for (int c = 0; c < 3; ++c) {
                rgb[c] = static_cast<float>(change.before[c] * threshold / largest);
                change.calm[c] = static_cast<double>(rgb[c]);
            }
            take(bright, layout, change);
        }
}

MapLayout latlongOf(const Spectrum& s) { return {.kind = Parameterization::Latlong, .size = s.rings}; }

/// The spectrum of what was taken out, rows after rows, so that little is held at a time.
Spectrum brightSpectrum(const SpectrumPart& part, const JobControl& job)
{
    constexpr int block = 256;
    const Spectrum& calm = part.calm;
    Spectrum sum = calm;
    std::map<int, std::vector<const BrightTexels::Change*>> blocks;
    for (const BrightTexels::Change& change : part.bright.changes)
        blocks[change.y / block].push_back(&change);
    const std::vector<float> black(static_cast<size_t>(block) * static_cast<size_t>(calm.ringLength) * 3, 0.0f);
    for (const auto& [index, changes] : blocks) {
        const RowRange rows{index * block, std::min(calm.rings, (index + 1) * block)};
        SpectrumBuilder builder(calm.ringLength, calm.rings, calm.bandLimit, rows);
        builder.addRows(rows.first, rows.end - rows.first, black.data(), job);
        for (const BrightTexels::Change* change : changes)
            builder.replace(change->x, change->y, glm::dvec3(0.0), change->before - change->calm);
        sum += builder.finish(job);
    }
    sum.secondMoment = calm.secondMoment + part.bright.squares;
    sum.least = calm.least;
    for (const BrightTexels::Change& change : part.bright.changes)
        for (int c = 0; c < 3; ++c)
            sum.peak = std::max(sum.peak, std::abs(change.before[c]));
    return sum;
}

} // namespace

SpectrumPart probeSpectrum(ProbeFile& probe, const SpectrumOptions& options, const JobControl& job)
{
    const MapLayout& layout = probe.layout();
    if (probe.isBuiltin() || probe.detection().orientation != glm::dmat3(1.0) || probe.detection().arrangement != Arrangement::Whole ||
        layout.kind != Parameterization::Latlong)
        throw InvalidArgument("PROBE: must be the file of a latlong; convert it to one first");
    if (options.degree < 1 || options.degree > largestBandLimit || options.degree >= layout.width())
        throw InvalidArgument("--degree: must lie in 1 to " + std::to_string(std::min(largestBandLimit, layout.width() - 1)) + "; it is " +
                              std::to_string(options.degree));
    const RowRange range = options.rows.value_or(RowRange{0, layout.height()});
    if (range.first < 0 || range.first >= range.end || range.end > layout.height())
        throw InvalidArgument("--rows: must be A:B with 0 <= A < B <= " + std::to_string(layout.height()) + ", the probe's rows; it is " +
                              std::to_string(range.first) + ":" + std::to_string(range.end));
    SpectrumPart part{.threshold = options.threshold, .rows = {range}, .probe = probe.rows().info().path.filename().string()};
    SpectrumBuilder builder(layout.width(), layout.height(), options.degree, range);
    constexpr int block = 32;
    std::vector<float> rows(static_cast<size_t>(block) * static_cast<size_t>(layout.width()) * 3);
    JobControl inner = job;
    inner.progress = nullptr;
    for (int y = range.first; y < range.end; y += block) {
        job.checkStop();
        const int count = std::min(block, range.end - y);
        probe.rows().readRows(y, count, rows.data());
        if (options.threshold > 0.0)
            takeBright(rows.data(), layout, y, count, options.threshold, part.bright);
        builder.addRows(y, count, rows.data(), inner);
        if (job.progress)
            job.progress(static_cast<float>(y + count - range.first) / static_cast<float>(range.end - range.first));
    }
    part.repaired = probe.rows().report();
    part.calm = builder.finish(job);
    return part;
}

SpectrumPart addSpectra(std::vector<SpectrumPart> parts)
{
    if (parts.empty())
        throw InvalidArgument("--add: names no file");
    const auto firstRow = [](const SpectrumPart& p) { return p.rows.front().first; };
    std::sort(parts.begin(), parts.end(), [&](const SpectrumPart& a, const SpectrumPart& b) { return firstRow(a) < firstRow(b); });
    SpectrumPart sum = std::move(parts.front());
    for (size_t i = 1; i < parts.size(); ++i) {
        SpectrumPart& part = parts[i];
        const auto differs = [&](const std::string& what, auto a, auto b) {
            if (a != b)
                throw InvalidArgument("--add: the parts differ in " + what + ", " + std::to_string(a) + " and " + std::to_string(b) +
                                      "; make all with the same options of one probe");
        };
        differs("the probe's columns", sum.calm.ringLength, part.calm.ringLength);
        differs("the probe's rows", sum.calm.rings, part.calm.rings);
        differs("degree", sum.calm.bandLimit, part.calm.bandLimit);
        differs("the threshold of bright texels", sum.threshold, part.threshold);
        if (sum.probe != part.probe)
            throw InvalidArgument("--add: the parts are of two probes, '" + shownPath(sum.probe) + "' and '" + shownPath(part.probe) + "'");
        sum.calm += part.calm;
        sum.repaired += part.repaired;
        sum.rows.insert(sum.rows.end(), part.rows.begin(), part.rows.end());
        for (const BrightTexels::Change& change : part.bright.changes)
            take(sum.bright, latlongOf(sum.calm), change);
    }
    std::sort(sum.rows.begin(), sum.rows.end(), [](const RowRange& a, const RowRange& b) { return a.first < b.first; });
    std::vector<RowRange> merged;
    for (const RowRange& rows : sum.rows) {
        if (!merged.empty() && rows.first < merged.back().end)
            throw InvalidArgument("--add: two parts hold row " + std::to_string(rows.first) + "; give each row once");
        if (!merged.empty() && rows.first == merged.back().end)
            merged.back().end = rows.end;
        else
            merged.push_back(rows);
    }
    sum.rows = std::move(merged);
    return sum;
}

void writeSpectrum(const std::filesystem::path& path, const SpectrumPart& part)
{
    field_json::OrderedJson json;
    field_json::Writer writer(json);
    const Header header = headerOf(part);
    Header::visitFields(header, writer);
    const std::string text = json.dump() + "\n";
    AtomicFile file(path);
    file.write(firstLine.data(), firstLine.size());
    file.write(text.data(), text.size());
    for (const auto& channel : part.calm.coefficients)
        file.write(channel.data(), channel.size() * sizeof(Complex));
    for (const BrightTexels::Change& change : part.bright.changes) {
        const std::array<double, numbersOfBright> numbers{static_cast<double>(change.x),
                                                          static_cast<double>(change.y),
                                                          change.before.r,
                                                          change.before.g,
                                                          change.before.b,
                                                          change.calm.r,
                                                          change.calm.g,
                                                          change.calm.b};
        file.write(numbers.data(), sizeof numbers);
    }
    file.commit();
}

void checkSpectrumName(const std::filesystem::path& path)
{
    if (const ImageFormat* const format = findFormat(path))
        throw InvalidArgument(path.string() + ": is named as a picture (" + std::string(format->label) +
                              "), and a spectrum is none; end it with .spectrum");
}

bool isSpectrumFile(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (findFormat(path) || !std::filesystem::is_regular_file(path, ignored))
        return false;
    std::ifstream stream(path, std::ios::binary);
    std::string line(firstLine.size(), '\0');
    stream.read(line.data(), static_cast<std::streamsize>(line.size()));
    return stream && line == firstLine;
}

SpectrumPart readSpectrum(const std::filesystem::path& path)
{
    const std::string name = path.string();
    if (!isSpectrumFile(path))
        throw FileError(name, "is no spectrum; make one with mirrorball spectrum PROBE -o FILE");
    noteRead(path);
    std::ifstream stream(path, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(firstLine.size()));
    std::string text;
    for (char c = 0; text.size() < longestHeader && stream.get(c) && c != '\n';)
        text += c;
    Header header;
    try {
        const field_json::Json json = field_json::parse(text, "a spectrum's header");
        field_json::Reader reader("", json);
        Header::visitFields(header, reader);
    } catch (const InvalidArgument& error) {
        throw FileError(name, std::string("is damaged: ") + error.what());
    }
    const MapLayout layout{.kind = Parameterization::Latlong, .size = header.height};
    const size_t count = coefficientCount(header.degree), bright = static_cast<size_t>(header.bright);
    const std::uintmax_t size =
        firstLine.size() + text.size() + 1 + 3 * count * sizeof(Complex) + bright * numbersOfBright * sizeof(double);
    std::error_code ignored;
    int row = 0;
    bool inOrder = layout.width() == header.width && header.degree < header.width;
    for (const HeaderRows& rows : header.rows) {
        inOrder = inOrder && (rows.first > row || (rows.first == 0 && row == 0)) && rows.first < rows.end && rows.end <= header.height;
        row = rows.end;
    }
    if (header.rows.empty() || !inOrder || std::filesystem::file_size(path, ignored) != size)
        throw FileError(name, "is damaged: its length or its rows are not those of its header; make it again");

    SpectrumPart part{.threshold = header.threshold, .probe = header.probe};
    for (const HeaderRows& rows : header.rows)
        part.rows.push_back({rows.first, rows.end});
    const auto whole = [](double value) { return static_cast<std::int64_t>(value); };
    part.repaired = {whole(header.nan), whole(header.positiveInfinity), whole(header.negativeInfinity), whole(header.negative),
                     whole(header.clamped)};
    Spectrum& s = part.calm;
    s.bandLimit = header.degree;
    s.rings = header.height;
    s.ringLength = header.width;
    s.peak = header.peak;
    s.least = header.least;
    s.secondMoment = header.secondMoment;
    const auto read = [&](std::span<double> numbers) {
        stream.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size_bytes()));
        if (!stream || !std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); }))
            throw FileError(name, "is damaged: it holds numbers that are not finite; make it again");
    };
    for (auto& channel : s.coefficients) {
        channel.resize(count);
        read({reinterpret_cast<double*>(channel.data()), 2 * count});
    }
    for (size_t i = 0; i < bright; ++i) {
        std::array<double, numbersOfBright> n{};
        read(n);
        if (!(n[0] >= 0 && n[0] < header.width && n[1] >= 0 && n[1] < header.height))
            throw FileError(name, "is damaged: a bright texel lies outside the probe; make it again");
        take(part.bright, layout, {static_cast<int>(n[0]), static_cast<int>(n[1]), {n[2], n[3], n[4]}, {n[5], n[6], n[7]}});
    }
    setUnit(s);
    return part;
}

FilterSource filterSource(SpectrumPart whole, const JobControl& job)
{
    if (!whole.isWhole()) {
        const int missing = whole.rows.front().first > 0 ? 0 : whole.rows.front().end;
        throw InvalidArgument("PROBE: the spectrum lacks rows of its probe, the first of them " + std::to_string(missing) +
                              "; add all parts with mirrorball spectrum --add PART... -o WHOLE");
    }
    if (whole.bright.changes.empty())
        return FilterSource(std::move(whole.calm));
    Spectrum all = brightSpectrum(whole, job);
    return {std::move(all), std::move(whole.calm), std::move(whole.bright)};
}

OpenedSource openSpectrum(const std::filesystem::path& path, const JobControl& job)
{
    std::vector<Stage> stages;
    SpectrumPart part = timedStage(stages, "read spectrum", [&] { return readSpectrum(path); });
    const RepairReport repaired = part.repaired;
    FilterSource source = timedStage(stages, "add bright texels", [&] { return filterSource(std::move(part), job); });
    return {std::move(source), repaired, "a spectrum is that of a latlong", true, std::move(stages)};
}

} // namespace mirrorball
