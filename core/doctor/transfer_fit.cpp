#include "transfer_fit.h"

#include "core/image/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace mirrorball {

namespace {

constexpr std::array allTransfers{Transfer::SrgbEncoded, Transfer::SrgbDecoded, Transfer::Reinhard, Transfer::ReinhardSrgb,
                                  Transfer::Filmic,      Transfer::FilmicSrgb,  Transfer::Clipped,  Transfer::ClippedSrgb};

double encoded(double x) { return x <= 1.0 ? encodeSrgb(static_cast<float>(x)) : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055; }
double decoded(double x) { return x <= 1.0 ? decodeSrgb(static_cast<float>(x)) : std::pow((x + 0.055) / 1.055, 2.4); }
double toned(double x, ToneCurve curve) { return toneMapped(static_cast<float>(x), curve); }

/// Mean of |ln((m + floor)/(p + floor))|, each at most 2: values far below the mean count little.
struct Compared {
    std::vector<double> map{}, truth{};
    double floor = 0.0;

    double error(Transfer transfer, double exposure, double gain) const
    {
        double sum = 0.0;
        for (size_t i = 0; i < map.size(); ++i) {
            const double made = gain * transferred(exposure * truth[i], transfer);
            sum += std::min(2.0, std::abs(std::log((map[i] + floor) / (made + floor))));
        }
        return sum / static_cast<double>(map.size());
    }
    /// The gain of a curve by powers, whose factor is free: the median of the quotients.
    double gain(Transfer transfer) const
    {
        std::vector<double> quotients;
        for (size_t i = 0; i < map.size(); ++i)
            if (const double made = transferred(truth[i], transfer); made > 0.0 && map[i] > floor)
                quotients.push_back(map[i] / made);
        if (quotients.empty())
            return 1.0;
        const auto middle = quotients.begin() + static_cast<std::ptrdiff_t>(quotients.size() / 2);
        std::nth_element(quotients.begin(), middle, quotients.end());
        return *middle;
    }
};

} // namespace

std::string_view name(Transfer transfer)
{
    static constexpr std::array<std::string_view, 9> names{"linear",
                                                           "sRGB-encoded",
                                                           "decoded from sRGB once too often",
                                                           "tone-mapped by x/(1+x)",
                                                           "tone-mapped by x/(1+x) and sRGB-encoded",
                                                           "tone-mapped by a filmic curve",
                                                           "tone-mapped by a filmic curve and sRGB-encoded",
                                                           "clipped at 1",
                                                           "clipped at 1 and sRGB-encoded"};
    return names[static_cast<size_t>(transfer)];
}

bool isReversible(Transfer transfer) { return transfer <= Transfer::SrgbDecoded; }

double transferred(double x, Transfer transfer)
{
    x = std::max(x, 0.0);
    switch (transfer) {
    case Transfer::Linear:
        return x;
    case Transfer::SrgbEncoded:
        return encoded(x);
    case Transfer::SrgbDecoded:
        return decoded(x);
    case Transfer::Reinhard:
        return toned(x, ToneCurve::Reinhard);
    case Transfer::ReinhardSrgb:
        return encoded(toned(x, ToneCurve::Reinhard));
    case Transfer::Filmic:
        return toned(x, ToneCurve::Filmic);
    case Transfer::FilmicSrgb:
        return encoded(toned(x, ToneCurve::Filmic));
    case Transfer::Clipped:
        return std::min(x, 1.0);
    case Transfer::ClippedSrgb:
        return encoded(std::min(x, 1.0));
    }
    return x;
}

Image undone(const Image& map, Transfer transfer)
{
    Image result = map;
    if (transfer == Transfer::SrgbEncoded || transfer == Transfer::ClippedSrgb)
        for (float& t : result.texels)
            t = static_cast<float>(decoded(std::max(t, 0.0f)));
    if (transfer == Transfer::SrgbDecoded)
        for (float& t : result.texels)
            t = static_cast<float>(encoded(std::max(t, 0.0f)));
    return result;
}

TransferFit fitTransfer(const Image& map, const Image& truth)
{
    Compared values;
    values.map.assign(map.texels.begin(), map.texels.end());
    values.truth.assign(truth.texels.begin(), truth.texels.end());
    for (double& v : values.map)
        v = std::max(v, 0.0);
    const double mean = std::accumulate(values.map.begin(), values.map.end(), 0.0) / static_cast<double>(values.map.size());
    values.floor = std::max(0.01 * mean, 1e-12);

    TransferFit fit;
    fit.exposure = values.gain(Transfer::Linear);
    fit.error = fit.linearError = values.error(Transfer::Linear, 1.0, fit.exposure);
    if (fit.linearError < 0.06 || mean <= 0.0)
        return fit;
    TransferFit best = fit;
    const auto consider = [&](Transfer transfer, double exposure, double gain) {
        if (const double error = values.error(transfer, exposure, gain); error < best.error)
            best = {transfer, isReversible(transfer) ? gain : exposure, error, fit.linearError};
    };
    for (const Transfer transfer : allTransfers) {
        if (isReversible(transfer))
            consider(transfer, 1.0, values.gain(transfer));
        else
            for (double stops = -4.0; stops <= 4.0; stops += 0.25)
                consider(transfer, std::exp2(stops), 1.0);
    }
    return best.error < 0.5 * fit.linearError && best.error < 0.25 ? best : fit;
}

Image averaged(const Image& image, int charts, int edge)
{
    const int height = image.height / charts, step = std::max(1, height / edge);
    Image small(std::max(1, image.width / step), std::max(1, height / step) * charts, 3);
    const int rows = small.height / charts;
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < 3; ++c) {
                double sum = 0.0;
                for (int j = 0; j < step; ++j)
                    for (int i = 0; i < step; ++i)
                        sum += image.texel(x * step + i, y / rows * height + y % rows * step + j)[c];
                small.texel(x, y)[c] = static_cast<float>(sum / (step * step));
            }
    return small;
}

} // namespace mirrorball
