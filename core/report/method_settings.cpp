#include "method_settings.h"

#include "core/base/shell_word.h"
#include "core/filter/lobe_row.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>
#include <sstream>
#include <type_traits>

namespace mirrorball {

namespace {

std::vector<MethodSetting> toleranceSweep(Method method, Sweep sweep, double wanted)
{
    std::set<double, std::greater<>> tolerances{wanted, 1e-5};
    if (sweep == Sweep::Usual)
        tolerances.insert({1e-2, 1e-3, 1e-4, 1e-6});
    std::vector<MethodSetting> settings;
    for (const double tolerance : tolerances)
        settings.push_back({.method = method, .tolerance = tolerance, .label = "tolerance " + shortNumber(tolerance)});
    return settings;
}

std::vector<MethodSetting> sampleSweep(Sweep sweep)
{
    std::vector<MethodSetting> settings;
    for (int samples = 16; samples <= 65536; samples *= sweep == Sweep::Usual ? 4 : 16)
        settings.push_back({.method = Method::Importance, .knobs = {.samples = samples}, .label = std::to_string(samples) + " samples"});
    return settings;
}

std::vector<MethodSetting> mipSweep()
{
    std::vector<MethodSetting> settings;
    const auto filterings = words(MipFiltering{});
    for (size_t i = 0; i < filterings.size(); ++i)
        settings.push_back({.method = Method::Mip,
                            .knobs = {.mipFiltering = static_cast<MipFiltering>(i)},
                            .label = "lambda by width " + std::string(filterings[i])});
    return settings;
}

MethodSetting paraboloidSetting(ParaboloidKernel kernel, double clamp, int largest)
{
    return {.method = Method::Paraboloid,
            .knobs = {.paraboloid = {.kernel = kernel, .clamp = clamp, .largestKernel = largest}},
            .label = std::string(wordOf(kernel)) + " clamp " + shortNumber(clamp) + " kernel " + std::to_string(largest)};
}

/// As published (000 section 3.2.5), wider, and with the exact kernel at three sizes.
std::vector<MethodSetting> paraboloidSweep(Sweep sweep)
{
    std::vector<MethodSetting> settings{paraboloidSetting(ParaboloidKernel::Blended, 0.1, 7),
                                        paraboloidSetting(ParaboloidKernel::Exact, 1e-3, 17)};
    if (sweep == Sweep::Usual)
        settings = {settings[0], paraboloidSetting(ParaboloidKernel::Blended, 0.01, 15),
                    paraboloidSetting(ParaboloidKernel::Exact, 1e-3, 9), settings[1], paraboloidSetting(ParaboloidKernel::Exact, 1e-4, 33)};
    return settings;
}

/// Every knob as the command line spells it.
std::vector<std::string> knobWords(const MethodKnobs& knobs)
{
    std::vector<std::string> spelled;
    MethodKnobs::visitFields(knobs, [&](const Field& field, const auto& value) {
        std::string text = " --" + std::string(field.name) + " ";
        std::replace(text.begin(), text.end(), '_', '-');
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_enum_v<Value>)
            text += wordOf(value);
        else if constexpr (std::is_same_v<Value, std::optional<double>>)
            text += value ? exactNumber(*value) : "none";
        else
            text += exactNumber(static_cast<double>(value));
        spelled.push_back(std::move(text));
    });
    return spelled;
}

} // namespace

PrefilterOptions MethodSetting::options(const Lobe& lobe, const MapLayout& target) const
{
    return {.lobe = lobe, .target = target, .method = method, .tolerance = tolerance, .knobs = knobs};
}

std::vector<MethodSetting> methodSettings(Method method, Sweep sweep, double tolerance)
{
    switch (method) {
    case Method::Importance:
        return sampleSweep(sweep);
    case Method::Mip:
        return mipSweep();
    case Method::Paraboloid:
        return paraboloidSweep(sweep);
    case Method::Reference:
    case Method::Sh9:
        return {{.method = method}};
    case Method::Auto:
    case Method::Spectral:
    case Method::Direct:
    case Method::Hierarchical:
        break;
    }
    return toleranceSweep(method, sweep, tolerance);
}

std::string exactNumber(double value)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string shortNumber(double value, int digits)
{
    if (!std::isfinite(value))
        return std::isnan(value) ? "not a number" : value > 0 ? "infinity" : "-infinity";
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    std::string words = text.data();
    if (const size_t e = words.find('e'); e != std::string::npos) { // 1e-03 reads 1e-3
        size_t digit = e + 2;
        while (digit + 1 < words.size() && words[digit] == '0')
            words.erase(digit, 1);
        if (words[e + 1] == '+')
            words.erase(e + 1, 1);
        return words;
    }
    if (value != 0.0 && std::abs(value) <= 0.01 && digits <= 3) { // 0.01 reads 1e-2 beside 1e-4 and 1e-5
        std::snprintf(text.data(), text.size(), "%.*e", digits - 1, value);
        words = text.data();
        const size_t exponent = words.find('e');
        std::string mantissa = words.substr(0, exponent);
        if (mantissa.find('.') != std::string::npos) {
            while (mantissa.back() == '0')
                mantissa.pop_back();
            if (mantissa.back() == '.')
                mantissa.pop_back();
        }
        return mantissa + "e" + std::to_string(std::stoi(words.substr(exponent + 1)));
    }
    return words;
}

std::string filterCommand(const std::string& probe, const PrefilterOptions& options)
{
    std::ostringstream command;
    command.precision(17);
    command << "mirrorball filter " << shellWord(probe) << " -o map.exr --lobe ";
    const LobeRow& lobe = rowOf(options.lobe.kind);
    if (!lobe.make)
        return {};
    command << lobe.word;
    if (lobe.value)
        command << " --" << lobe.parameter << ' ' << exactNumber(options.lobe.*lobe.value);
    command << " --to " << name(options.target.kind) << " --size " << options.target.size;
    if (options.target.border > 0)
        command << " --border " << options.target.border;
    command << " --method " << name(options.method);
    const std::vector<std::string> usual = knobWords({}), chosen = knobWords(options.knobs);
    for (size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i] != usual[i])
            command << chosen[i];
    if (followsTolerance(options.method))
        command << " --tolerance " << shortNumber(options.tolerance);
    return command.str();
}

} // namespace mirrorball
