#include "core/filter/method_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace mirrorball {
namespace {

std::vector<std::string> fieldsOfKnobs()
{
    std::vector<std::string> names;
    const MethodKnobs knobs;
    MethodKnobs::visitFields(knobs, [&](const Field& field, const auto&) { names.emplace_back(field.name); });
    return names;
}

TEST(MethodRows, AreFoundAgainByTheirWord)
{
    for (const Method method : allMethods) {
        const MethodRow& row = rowOf(method);
        EXPECT_FALSE(row.name.empty());
        EXPECT_EQ(name(method), row.name);
        EXPECT_EQ(methodFromName(row.name), method) << row.name;
        EXPECT_FALSE(row.help.empty()) << row.name;
        EXPECT_NE(row.help.back(), '.') << row.name;
    }
    EXPECT_EQ(methodFromName("cone"), std::nullopt);
}

TEST(MethodRows, NameKnobsThatThereAre)
{
    const std::vector<std::string> fields = fieldsOfKnobs();
    for (const Method method : allMethods)
        for (const std::string_view knob : knobsOf(method))
            EXPECT_NE(std::find(fields.begin(), fields.end(), knob), fields.end()) << name(method) << ' ' << knob;
}

/// A knob's help starts with the method that it belongs to, whose row says the same.
TEST(MethodRows, LeaveNoKnobWithoutItsMethod)
{
    for (const std::string& knob : fieldsOfKnobs())
        EXPECT_FALSE(ownersOf(knob).empty()) << knob;
    const MethodKnobs knobs;
    MethodKnobs::visitFields(knobs, [](const Field& field, const auto&) {
        EXPECT_TRUE(field.help.starts_with(ownersOf(field.name))) << field.name << ": " << field.help;
    });
    EXPECT_EQ(ownersOf("tolerance"), "");
}

/// Whoever puts something else in the lobe's place promises nothing, and only who promises has the tolerance for a knob.
TEST(MethodRows, ApproximateWhereTheyHaveAModelOfIt)
{
    const ProbeTraits probe{.width = 64};
    for (const Method method : allMethods) {
        const PrefilterOptions options{.lobe = diffuseLobe(), .target = {Parameterization::Cube, 4, 0}, .method = method};
        EXPECT_EQ(keepsTolerance(method), transferModel(method, options, probe).k.empty()) << name(method);
        EXPECT_TRUE(keepsTolerance(method) || !followsTolerance(method)) << name(method);
    }
}

TEST(MethodRows, SayWhatCannotRunRowByRow)
{
    for (const Method method : allMethods) {
        const bool isRefused = !refusal(method, {.lobe = diffuseLobe()}, {.width = 64, .streamed = true}).empty();
        EXPECT_EQ(isRefused, rowOf(method).needsTexels) << name(method);
        EXPECT_EQ(refusal(method, {.lobe = diffuseLobe()}, {.width = 64}), "") << name(method);
    }
}

} // namespace
} // namespace mirrorball
