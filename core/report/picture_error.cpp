#include "picture_error.h"

#include "core/base/error.h"
#include "core/image/color.h"

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace mirrorball {

namespace {

constexpr double sigma = 1.5, c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;

std::array<double, ssimWindow> windowWeights()
{
    std::array<double, ssimWindow> weights{};
    for (int i = 0; i < ssimWindow; ++i) {
        const double x = i - ssimWindow / 2;
        weights[static_cast<size_t>(i)] = std::exp(-0.5 * x * x / (sigma * sigma));
    }
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& w : weights)
        w /= sum;
    return weights;
}

double luma(const float* rgb) { return luminance({rgb[0], rgb[1], rgb[2]}); }

/// What SSIM knows of two pictures under a window: means of E, R, E^2, R^2 and E R.
using Moments = std::array<double, 5>;

double similarity(const Moments& m)
{
    const double varianceE = m[2] - m[0] * m[0], varianceR = m[3] - m[1] * m[1], covariance = m[4] - m[0] * m[1];
    return (2.0 * m[0] * m[1] + c1) * (2.0 * covariance + c2) / ((m[0] * m[0] + m[1] * m[1] + c1) * (varianceE + varianceR + c2));
}

/// The sum of SSIM over the windows whose first row is y. The window is separable: down the columns first, then along the row.
double rowSimilarity(const Image& picture, const Image& reference, int y, const std::array<double, ssimWindow>& weights)
{
    std::vector<Moments> columns(static_cast<size_t>(picture.width));
    for (int j = 0; j < ssimWindow; ++j) {
        const double w = weights[static_cast<size_t>(j)];
        for (int x = 0; x < picture.width; ++x) {
            const double e = luma(picture.texel(x, y + j)), r = luma(reference.texel(x, y + j));
            Moments& sums = columns[static_cast<size_t>(x)];
            sums[0] += w * e;
            sums[1] += w * r;
            sums[2] += w * e * e;
            sums[3] += w * r * r;
            sums[4] += w * e * r;
        }
    }
    double sum = 0.0;
    for (size_t x = 0; x + ssimWindow <= columns.size(); ++x) {
        Moments moments{};
        for (size_t i = 0; i < ssimWindow; ++i)
            for (size_t k = 0; k < moments.size(); ++k)
                moments[k] += weights[i] * columns[x + i][k];
        sum += similarity(moments);
    }
    return sum;
}

void check(const Image& picture, const Image& reference)
{
    if (picture.width != reference.width || picture.height != reference.height)
        throw InvalidArgument("picture error: the pictures are " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                              " and " + std::to_string(reference.width) + " x " + std::to_string(reference.height) +
                              " pixels; make them of one size");
    if (picture.channels < 3 || reference.channels < 3)
        throw InvalidArgument("picture error: pictures need three channels");
    if (picture.width < ssimWindow || picture.height < ssimWindow)
        throw InvalidArgument("picture error: pictures need " + std::to_string(ssimWindow) + " x " + std::to_string(ssimWindow) +
                              " pixels, the window of SSIM");
}

} // namespace

PictureError pictureError(const Image& picture, const Image& reference, const JobControl& job)
{
    check(picture, reference);
    const auto weights = windowWeights();
    const int windowRows = picture.height - ssimWindow + 1;
    struct Row {
        double difference2 = 0.0, reference2 = 0.0, similarity = 0.0;
    };
    std::vector<Row> rows(static_cast<size_t>(picture.height)); // added up in one order, whoever made them
    parallelRows(picture.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            Row& row = rows[static_cast<size_t>(y)];
            for (int x = 0; x < picture.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const double r = reference.texel(x, y)[c], difference = picture.texel(x, y)[c] - r;
                    row.difference2 += difference * difference;
                    row.reference2 += r * r;
                }
            if (y < windowRows)
                row.similarity = rowSimilarity(picture, reference, y, weights);
        }
    });
    Row all;
    for (const Row& row : rows) {
        all.difference2 += row.difference2;
        all.reference2 += row.reference2;
        all.similarity += row.similarity;
    }
    const double values = 3.0 * picture.width * picture.height, windows = double(picture.width - ssimWindow + 1) * windowRows;
    return {.relRms = all.difference2 > 0.0 ? std::sqrt(all.difference2 / all.reference2) : 0.0,
            .psnr = -10.0 * std::log10(all.difference2 / values),
            .ssim = all.similarity / windows};
}

} // namespace mirrorball
