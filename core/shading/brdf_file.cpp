#include "brdf_file.h"

#include "observer.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/base/file_log.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace mirrorball {

namespace {

using Sample = MeasuredBrdf::Sample;

constexpr std::uintmax_t largestText = 512u << 20; ///< bytes of a table: far more than any measurement has

std::string stem(const std::filesystem::path& path) { return path.filename().string(); }

std::string extension(const std::filesystem::path& path)
{
    std::string text = path.extension().string();
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::uintmax_t sizeOf(const std::filesystem::path& path)
{
    noteRead(path);
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw FileError(path.string(),
                        std::filesystem::exists(path, error) ? "is no file; name a measured BRDF" : "is not there; check the path");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error)
        throw FileError(path.string(), "cannot be read: " + error.message());
    return size;
}

// ---- MERL ----------------------------------------------------------------------------------------------------------------------

constexpr std::array<int, 3> merlSteps{90, 90, 180};
constexpr size_t merlCells = 90 * 90 * 180;
constexpr std::uintmax_t merlBytes = 12 + 3 * merlCells * sizeof(double);

MeasuredBrdf readMerl(const std::filesystem::path& path)
{
    const std::uintmax_t size = sizeOf(path);
    std::ifstream file(path, std::ios::binary);
    std::array<std::int32_t, 3> steps{};
    file.read(reinterpret_cast<char*>(steps.data()), 12);
    if (!file)
        throw FileError(path.string(), "ends at byte " + std::to_string(size) + ", inside the three numbers that a MERL file starts with");
    for (size_t i = 0; i < 3; ++i)
        if (steps[i] != merlSteps[i])
            throw FileError(path.string(), "at byte " + std::to_string(4 * i) + ": expected " + std::to_string(merlSteps[i]) +
                                               ", as the isotropic MERL files have; it is " + std::to_string(steps[i]));
    if (size != merlBytes)
        throw FileError(path.string(), "ends at byte " + std::to_string(size) + "; a MERL file of 90 x 90 x 180 x 3 values has " +
                                           std::to_string(merlBytes));
    constexpr std::array<double, 3> scale{1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
    std::array<std::vector<float>, 3> values;
    std::vector<double> channel(merlCells);
    for (size_t c = 0; c < 3; ++c) {
        file.read(reinterpret_cast<char*>(channel.data()), static_cast<std::streamsize>(merlCells * sizeof(double)));
        if (!file)
            throw FileError(path.string(), "cannot be read to its end");
        values[c].reserve(merlCells);
        for (const double v : channel) {
            const double scaled = v * scale[c];
            values[c].push_back(std::isfinite(scaled) && scaled >= 0.0 && scaled < 1e30 ? static_cast<float>(scaled) : -1.0f);
        }
    }
    MeasuredBrdf brdf = halfAngleBrdf(stem(path), std::move(values));
    if (brdf.gaps().holes == brdf.gaps().samples)
        throw FileError(path.string(), "holds no value of at least 0: every one is a hole");
    return brdf;
}

// ---- text ----------------------------------------------------------------------------------------------------------------------

struct Line {
    size_t number;
    std::vector<std::string_view> words;
};

/// The lines that are neither empty nor remarks, cut at blanks, commas, semicolons and tabs.
std::vector<Line> linesOf(std::string_view text)
{
    std::vector<Line> lines;
    size_t number = 0;
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        at = end + 1;
        ++number;
        const auto first = line.find_first_not_of(" \t\r");
        if (first == std::string_view::npos || line[first] == '#')
            continue;
        Line cut{number, {}};
        constexpr std::string_view between = " \t\r,;";
        for (size_t from = line.find_first_not_of(between); from != std::string_view::npos;) {
            const size_t to = std::min(line.find_first_of(between, from), line.size());
            cut.words.push_back(line.substr(from, to - from));
            from = line.find_first_not_of(between, to);
        }
        if (!cut.words.empty())
            lines.push_back(std::move(cut));
    }
    return lines;
}

std::string readText(const std::filesystem::path& path)
{
    const std::uintmax_t size = sizeOf(path);
    if (size == 0)
        throw FileError(path.string(), "is empty");
    if (size > largestText)
        throw FileError(path.string(), "has over 512 MB, more than any table of a BRDF");
    std::string text(size, '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file.read(text.data(), static_cast<std::streamsize>(size)))
        throw FileError(path.string(), "cannot be read to its end");
    if (text.back() != '\n')
        throw FileError(path.string(), "ends inside row " + std::to_string(1 + std::count(text.begin(), text.end(), '\n')) + ", byte " +
                                           std::to_string(size) + "; expected a line break after the last row");
    return text;
}

std::string rowText(const Line& line) { return "row " + std::to_string(line.number) + ": "; }

double number(const std::filesystem::path& path, const Line& line, size_t column, const char* what)
{
    if (column >= line.words.size())
        throw FileError(path.string(), rowText(line) + "ends after " + std::to_string(line.words.size()) + " values; expected " + what +
                                           " as value " + std::to_string(column + 1));
    const std::string_view word = line.words[column];
    double value = 0.0;
    const std::string_view digits = !word.empty() && word.front() == '+' ? word.substr(1) : word;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
        throw FileError(path.string(),
                        rowText(line) + "expected " + what + " as value " + std::to_string(column + 1) + "; it is " + inQuotes(word));
    return value;
}

/// The cosines of a pair of directions; nothing where one is not above the horizon.
std::optional<Sample> sampleAt(double thetaI, double thetaR, double phi)
{
    const double nl = std::cos(thetaI), nv = std::cos(thetaR);
    if (!(nl > 1e-6 && nv > 1e-6))
        return std::nullopt;
    return Sample{nl, nv, std::clamp(nl * nv + std::sin(thetaI) * std::sin(thetaR) * std::cos(phi), -1.0, 1.0), glm::dvec3(0.0)};
}

MeasuredBrdf finish(const std::filesystem::path& path, std::vector<Sample> samples, MeasuredBrdf::Gaps gaps)
{
    if (samples.empty())
        throw FileError(path.string(), "holds no row with a value of at least 0 above the horizon");
    return scatteredBrdf(stem(path), std::move(samples), gaps);
}

// ---- Cornell -------------------------------------------------------------------------------------------------------------------

MeasuredBrdf readCornell(const std::filesystem::path& path)
{
    const std::string text = readText(path);
    const std::vector<Line> lines = linesOf(text);
    if (lines.empty())
        throw FileError(path.string(), "holds remarks only; expected the number of wavelengths");
    const double count = number(path, lines[0], 0, "the number of wavelengths");
    if (lines[0].words.size() != 1 || !(count >= 1.0 && count <= 10000.0) || count != std::floor(count))
        throw FileError(path.string(), rowText(lines[0]) + "expected the number of wavelengths alone, a whole number from 1 to 10000");
    const auto wanted = static_cast<size_t>(count);
    std::vector<double> wavelengths;
    size_t at = 1;
    for (; at < lines.size() && wavelengths.size() < wanted; ++at)
        for (size_t i = 0; i < lines[at].words.size(); ++i) {
            wavelengths.push_back(number(path, lines[at], i, "a wavelength in nm"));
            const bool rises = wavelengths.size() < 2 || wavelengths.back() > wavelengths[wavelengths.size() - 2];
            if (!(wavelengths.back() > 0.0 && rises) || wavelengths.size() > wanted)
                throw FileError(path.string(), rowText(lines[at]) + "expected " + std::to_string(wanted) + " increasing wavelengths in nm");
        }
    if (wavelengths.size() < wanted)
        throw FileError(path.string(),
                        "ends after " + std::to_string(wavelengths.size()) + " of " + std::to_string(wanted) + " wavelengths");
    const std::vector<glm::dvec3> weights = observerWeights(wavelengths);

    MeasuredBrdf::Gaps gaps{.samples = lines.size() - at};
    std::vector<Sample> samples;
    samples.reserve(gaps.samples);
    for (; at < lines.size(); ++at) {
        const Line& line = lines[at];
        const double thetaI = number(path, line, 0, "theta i in radians"), phiI = number(path, line, 1, "phi i in radians");
        const double thetaS = number(path, line, 2, "theta s in radians"), phiS = number(path, line, 3, "phi s in radians");
        auto sample = sampleAt(thetaI, thetaS, phiS - phiI);
        bool whole = sample.has_value();
        for (size_t i = 0; i < wanted; ++i) {
            const double value = number(path, line, 4 + i, "a spectral value");
            whole = whole && std::isfinite(value) && value >= 0.0 && value < 1e30;
            if (whole)
                sample->value += value * weights[i];
        }
        if (line.words.size() != 4 + wanted)
            throw FileError(path.string(), rowText(line) + "expected 4 angles and " + std::to_string(wanted) +
                                               " spectral values; there are " + std::to_string(line.words.size()) + " values");
        if (whole)
            samples.push_back(*sample);
        else
            ++gaps.holes;
    }
    return finish(path, std::move(samples), gaps);
}

// ---- plain tables --------------------------------------------------------------------------------------------------------------

/// A column's name without blanks, underscores, case and what stands after a slash or bracket.
std::string plainName(std::string_view word)
{
    std::string name;
    for (const char c : word.substr(0, word.find_first_of("/([")))
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

struct Columns {
    std::optional<size_t> thetaI, phiI, thetaR, phiR, lambda, value, r, g, b;
};

Columns columnsOf(const std::filesystem::path& path, const Line& heads)
{
    Columns columns;
    const std::map<std::string_view, std::optional<size_t> Columns::*> known{{"thetai", &Columns::thetaI},
                                                                             {"phii", &Columns::phiI},
                                                                             {"phi", &Columns::phiI},
                                                                             {"thetar", &Columns::thetaR},
                                                                             {"thetao", &Columns::thetaR},
                                                                             {"thetas", &Columns::thetaR},
                                                                             {"phir", &Columns::phiR},
                                                                             {"phio", &Columns::phiR},
                                                                             {"phis", &Columns::phiR},
                                                                             {"lambda", &Columns::lambda},
                                                                             {"wavelength", &Columns::lambda},
                                                                             {"value", &Columns::value},
                                                                             {"f", &Columns::value},
                                                                             {"fr", &Columns::value},
                                                                             {"fr11", &Columns::value},
                                                                             {"brdf", &Columns::value},
                                                                             {"r", &Columns::r},
                                                                             {"g", &Columns::g},
                                                                             {"b", &Columns::b}};
    for (size_t i = 0; i < heads.words.size(); ++i)
        if (heads.words[i].find('/') == std::string_view::npos) // a ratio of columns is none of these
            if (const auto found = known.find(plainName(heads.words[i])); found != known.end() && !(columns.*found->second))
                columns.*found->second = i;
    const bool isColor = columns.r && columns.g && columns.b, isSpectral = columns.lambda && columns.value;
    if (!columns.thetaI || !columns.thetaR || !columns.phiR || !(isColor || isSpectral))
        throw FileError(path.string(), rowText(heads) + "expected the names of the columns: theta_i, theta_r, phi_r, and r, g, b or "
                                                        "lambda and value");
    return columns;
}

MeasuredBrdf readTable(const std::filesystem::path& path)
{
    const std::string text = readText(path);
    const std::vector<Line> lines = linesOf(text);
    if (lines.empty())
        throw FileError(path.string(), "holds remarks only; expected a line that names the columns");
    const Columns columns = columnsOf(path, lines[0]);
    const bool isColor = columns.r && columns.g && columns.b;
    struct Spectrum {
        Sample sample;
        std::map<double, double> values;
    };
    std::map<std::array<std::int64_t, 3>, Spectrum> spectra; // by angles, to a ten-thousandth of a degree
    MeasuredBrdf::Gaps gaps{.samples = lines.size() - 1};
    std::vector<Sample> samples;
    for (size_t at = 1; at < lines.size(); ++at) {
        const Line& line = lines[at];
        const auto degrees = [&](size_t column, const char* what) { return number(path, line, column, what) * pi / 180.0; };
        const double thetaI = degrees(*columns.thetaI, "theta_i"), thetaR = degrees(*columns.thetaR, "theta_r");
        const double phi = degrees(*columns.phiR, "phi_r") - (columns.phiI ? degrees(*columns.phiI, "phi_i") : 0.0);
        auto sample = sampleAt(thetaI, thetaR, phi);
        const auto isValue = [](double v) { return std::isfinite(v) && v >= 0.0 && v < 1e30; };
        if (isColor) {
            const glm::dvec3 rgb(number(path, line, *columns.r, "r"), number(path, line, *columns.g, "g"),
                                 number(path, line, *columns.b, "b"));
            if (sample && isValue(rgb.r) && isValue(rgb.g) && isValue(rgb.b)) {
                sample->value = rgb;
                samples.push_back(*sample);
            } else {
                ++gaps.holes;
            }
            continue;
        }
        double lambda = number(path, line, *columns.lambda, "the wavelength");
        const double value = number(path, line, *columns.value, "the value");
        if (!(lambda > 0.0 && lambda < 1e6))
            throw FileError(path.string(), rowText(line) + "expected a wavelength in nm or micrometers; it is " + numberText(lambda));
        if (lambda < 10.0)
            lambda *= 1000.0;
        if (!sample || !isValue(value)) {
            ++gaps.holes;
            continue;
        }
        const auto rounded = [](double angle) { return std::llround(angle * 1e4 * 180.0 / pi); };
        Spectrum& spectrum = spectra[{rounded(thetaI), rounded(thetaR), rounded(phi)}];
        spectrum.sample = *sample;
        spectrum.values[lambda] = value;
    }
    for (auto& [angles, spectrum] : spectra) {
        std::vector<double> wavelengths;
        for (const auto& [lambda, value] : spectrum.values)
            wavelengths.push_back(lambda);
        const std::vector<glm::dvec3> weights = observerWeights(wavelengths);
        size_t i = 0;
        for (const auto& [lambda, value] : spectrum.values)
            spectrum.sample.value += value * weights[i++];
        samples.push_back(spectrum.sample);
    }
    return finish(path, std::move(samples), gaps);
}

} // namespace

bool isBrdfFile(const std::filesystem::path& path)
{
    const std::string ext = extension(path);
    return ext == ".binary" || ext == ".brdf" || ext == ".csv" || ext == ".txt";
}

MeasuredBrdf readBrdf(const std::filesystem::path& path)
{
    const std::string ext = extension(path);
    if (ext == ".binary")
        return readMerl(path);
    if (ext == ".brdf")
        return readCornell(path);
    if (ext == ".csv" || ext == ".txt")
        return readTable(path);
    throw FileError(path.string(), "is no measured BRDF by its name; expected .binary (MERL), .brdf (Cornell), .csv or .txt (a table)");
}

} // namespace mirrorball
