#include "core/spheremap/evaluation/levels_cache.h"

#include "support/stroke_builders.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirrorball {
namespace {

TEST(LevelsCache, PatchesMakeTheLevelsOfAFullEvaluation)
{
    for (const int size : {512, 100}) { // 100, 50, 25, 12, 6, 3, 1
        SphereMapDocument document;
        document.layers = {{.content = GradientLayer{}},
                           {.content = PaintLayer{.unit = WidthUnit::Pixels, .reference = 128, .strokes = handDrawnStrokes(3, 5, 0.06)}},
                           {.content = SilhouetteLayer{.width = 2.0, .unit = WidthUnit::Pixels}, .lastLevel = 3}};
        LevelsCache cache({.size = size});
        std::vector<Image> levels(evaluateLevels(document, size).size());
        bool isFirst = true;
        for (const Stroke& stroke : handDrawnStrokes(5, 9, 0.03, 0.3)) {
            for (LevelPatch& patch : cache.update(document)) {
                Image& level = levels[static_cast<size_t>(patch.level)];
                if (level.empty())
                    level = Image(size >> patch.level, size >> patch.level, 4);
                for (int y = 0; y < patch.texels.height; ++y)
                    std::copy_n(patch.texels.row(y), static_cast<size_t>(patch.texels.width) * 4,
                                level.texel(patch.rect.x0, patch.rect.y0 + y));
                if (!isFirst && patch.level == 1 && size == 512) {
                    EXPECT_LT(patch.texels.width * patch.texels.height, level.width * level.height) << "only what the stroke touched";
                }
            }
            isFirst = false;
            const std::vector<Image> expected = evaluateLevels(document, size);
            for (size_t i = 1; i < expected.size(); ++i)
                ASSERT_EQ(levels[i], expected[i]) << size << ", level " << i;
            std::get<PaintLayer>(document.layers[1].content).strokes.push_back(stroke);
        }
    }
}

} // namespace
} // namespace mirrorball
