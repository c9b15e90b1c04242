#include "core/image/repair.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/image/repaired_reader.h"
#include "support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace mirrorball {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

/// One row whose red channel holds `values`; green and blue are 1.
Image redRow(const std::vector<float>& values)
{
    Image image(static_cast<int>(values.size()), 1, 3, 1.0f);
    for (size_t x = 0; x < values.size(); ++x)
        image.texel(static_cast<int>(x), 0)[0] = values[x];
    return image;
}

std::vector<float> red(const Image& image)
{
    std::vector<float> values;
    for (int x = 0; x < image.width; ++x)
        values.push_back(image.texel(x, 0)[0]);
    return values;
}

std::vector<float> repaired(const std::vector<float>& values, NegativePolicy policy = NegativePolicy::Keep)
{
    Image image = redRow(values);
    repair(image, policy);
    return red(image);
}

/// An image as a stream.
class HeldRows final : public ImageReader {
public:
    explicit HeldRows(const Image& image) : m_image(image)
    {
        m_info.width = image.width;
        m_info.height = image.height;
    }
    const ImageFileInfo& info() const override { return m_info; }
    void readRows(int firstRow, int rows, float* texels) override
    {
        std::copy_n(m_image.row(firstRow), static_cast<size_t>(rows * m_image.width) * 3, texels);
    }

private:
    Image m_image;
    ImageFileInfo m_info{};
};

TEST(Repair, LeavesASoundImageAlone)
{
    Image image(7, 5, 3, 0.25f);
    const Image before = image;
    EXPECT_EQ(repair(image, NegativePolicy::Clamp), RepairReport{});
    EXPECT_EQ(image, before);
}

TEST(Repair, InterpolatesARunOfNanBetweenItsNeighbors) { EXPECT_EQ(repaired({1, nan, nan, nan, 5}), (std::vector<float>{1, 2, 3, 4, 5})); }

TEST(Repair, InterpolatesAroundTheEndsOfTheRow)
{
    // Left of x = 0 lies x = 3 (value 6, one step), to the right x = 2 (value 3, two steps).
    EXPECT_EQ(repaired({nan, nan, 3, 6}), (std::vector<float>{5, 4, 3, 6}));
    EXPECT_EQ(repaired({2, 8, nan, nan}), (std::vector<float>{2, 8, 6, 4}));
}

TEST(Repair, FillsARowWithOneFiniteValueWithItAndARowWithNoneWithZero)
{
    EXPECT_EQ(repaired({nan, 7, nan}), (std::vector<float>{7, 7, 7}));
    EXPECT_EQ(repaired({nan, nan}), (std::vector<float>{0, 0}));
    EXPECT_EQ(repaired({nan}), (std::vector<float>{0}));
}

TEST(Repair, TurnsInfinityIntoTheLargestHalf)
{
    EXPECT_EQ(repaired({inf, 1, -inf}), (std::vector<float>{65504, 1, -65504}));
    EXPECT_EQ(repaired({inf, 1, -inf}, NegativePolicy::Clamp), (std::vector<float>{65504, 1, 0}));
}

TEST(Repair, DoesNotSpreadASunIntoNanBesideIt) { EXPECT_EQ(repaired({2, nan, inf, 2}), (std::vector<float>{2, 2, 65504, 2})); }

TEST(Repair, KeepsOrClampsNegativesAndCountsThemEitherWay)
{
    Image kept = redRow({-1, 2, -0.0f});
    EXPECT_EQ(repair(kept, NegativePolicy::Keep), (RepairReport{.negative = 1}));
    EXPECT_EQ(red(kept), (std::vector<float>{-1, 2, 0}));

    Image clamped = redRow({-1, 2, -0.0f});
    EXPECT_EQ(repair(clamped, NegativePolicy::Clamp), (RepairReport{.negative = 1, .clamped = 1}));
    EXPECT_EQ(red(clamped), (std::vector<float>{0, 2, 0}));
}

TEST(Repair, InterpolatesBetweenClampedValues)
{
    EXPECT_EQ(repaired({-4, nan, 2}, NegativePolicy::Clamp), (std::vector<float>{0, 1, 2}));
    EXPECT_EQ(repaired({-4, nan, 2}, NegativePolicy::Keep), (std::vector<float>{-4, -1, 2}));
}

TEST(Repair, TreatsEachChannelByItself)
{
    Image image(3, 1, 3, 0.0f);
    image.texels = {1, 10, nan, nan, 20, 200, 3, inf, 300};
    const RepairReport report = repair(image, NegativePolicy::Keep);
    EXPECT_EQ(image.texels, (std::vector<float>{1, 10, 250, 2, 20, 200, 3, 65504, 300}));
    EXPECT_EQ(report, (RepairReport{.nan = 2, .positiveInfinity = 1}));
}

TEST(Repair, OfBlocksOfRowsEqualsRepairOfTheWhole)
{
    Image whole(64, 40, 3, 1.0f);
    for (size_t i = 0; i < whole.texels.size(); ++i) {
        const size_t hash = i * 2654435761u >> 7;
        whole.texels[i] = hash % 11 == 0 ? nan : hash % 13 == 0 ? inf : hash % 17 == 0 ? -inf : static_cast<float>(hash % 19) - 3.0f;
    }
    // Rows without a value: of all channels at both ends and in the middle, and of one channel.
    for (const int y : {0, 1, 12, 13, 14, 39})
        std::fill_n(whole.row(y), 64 * 3, nan);
    for (int x = 0; x < 64; ++x)
        whole.texel(x, 20)[1] = whole.texel(x, 15)[2] = x % 2 ? nan : inf;
    const Image blocks = whole;
    const RepairReport atOnce = repair(whole, NegativePolicy::Keep);
    for (const int block : {1, 2, 7, 40}) {
        RepairedReader stream(std::make_unique<HeldRows>(blocks), NegativePolicy::Keep);
        Image streamed(whole.width, whole.height, 3);
        for (int y = 0; y < whole.height; y += block)
            stream.readRows(y, std::min(block, whole.height - y), streamed.row(y));
        EXPECT_EQ(stream.report(), atOnce) << block;
        EXPECT_EQ(streamed, whole) << block;
    }
}

TEST(Repair, FillsRowsWithoutAValueBetweenTheirNeighbors)
{
    Image image(2, 6, 3, nan);
    for (int x = 0; x < 2; ++x)
        for (int c = 0; c < 3; ++c) {
            image.texel(x, 1)[c] = 1.0f;
            image.texel(x, 4)[c] = 4.0f;
        }
    EXPECT_EQ(repair(image, NegativePolicy::Keep).filledRows, 4 * 3);
    for (int y = 0; y < 6; ++y)
        EXPECT_EQ(image.texel(1, y)[2], std::vector<float>({1, 1, 2, 3, 4, 4})[static_cast<size_t>(y)]) << y;
}

TEST(Repair, RefusesAStreamWithoutAFiniteValue)
{
    RepairedReader stream(std::make_unique<HeldRows>(Image(4, 2, 3, inf)), NegativePolicy::Keep);
    Image read(4, 2, 3);
    EXPECT_THROW(stream.readRows(0, 2, read.row(0)), FileError);
}

TEST(Repair, DescribesWhatItFoundInOneLine)
{
    EXPECT_EQ(describe({}), "no NaN, infinite or negative values");
    EXPECT_EQ(describe({.nan = 6, .positiveInfinity = 11, .negativeInfinity = 1}), "6 NaN, 12 infinite values repaired");
    EXPECT_EQ(describe({.nan = 1, .negative = 5}), "1 NaN, 0 infinite values repaired; 5 negative values kept");
    EXPECT_EQ(describe({.negative = 5, .clamped = 5}), "5 negative values clamped to 0");
}

TEST(Repair, FindsTheNonFiniteValuesOfOpenExrsTestPicture)
{
    SHARED_DATA_OR_SKIP(path, "edgecases/BrightRingsNanInf.exr");
    Image image = readImage(path);
    EXPECT_EQ(repair(image, NegativePolicy::Keep).nonFinite(), 18); // counted with OpenImageIO's oiiotool --stats
    EXPECT_EQ(repair(image, NegativePolicy::Keep).nonFinite(), 0);
}

TEST(Repair, KeepsTheNegativesOfAWideGamut)
{
    SHARED_DATA_OR_SKIP(path, "edgecases/WideColorGamut.exr"); // says Rec.709 primaries, so its stored values are not converted
    Image image = readImage(path);
    const Image before = image;
    EXPECT_EQ(repair(image, NegativePolicy::Keep), (RepairReport{.negative = 128284})); // counted as above
    EXPECT_EQ(image, before);
}

} // namespace
} // namespace mirrorball
