#include "cut_out.h"
#include "preview_widget.h"

#include <algorithm>
#include <utility>

// What a stroke that is being drawn changes in the map that is shown.
namespace mirrorball::studio {

namespace {

constexpr int patchGrid = 16; ///< texels: what a stroke touched is taken in whole squares, so that four coarser levels are exact

TexelRect onGrid(const TexelRect& rect, int size)
{
    const auto up = [size](int x) { return std::min((x + patchGrid - 1) / patchGrid * patchGrid, size); };
    return {rect.x0 / patchGrid * patchGrid, rect.y0 / patchGrid * patchGrid, up(rect.x1), up(rect.y1)};
}

} // namespace

// A map that was made while a stroke goes on knows nothing of the stroke: it gets all of it.
/// @return whether there was something new
bool PreviewWidget::patchSphereMap(const PreparedScene& made)
{
    const SphereMapChain chain = made.maps.sphereMaps.empty() ? nullptr : made.maps.sphereMaps.front();
    if (std::exchange(m_patchedMap, chain) != chain) {
        m_freshRect = m_strokeRect;
        m_freshLevels = m_strokeLevels;
    }
    const Image& picture = m_workspace.sphereMap.picture();
    if (!chain || m_freshRect.empty() || chain->levels.front().width != picture.width)
        return false;
    const TexelRect rect = onGrid(std::exchange(m_freshRect, {}), picture.width);
    SphereMapPatch patch{.chain = chain, .texels = cutOut(picture, rect), .rect = rect};
    const std::vector<TexelRect> fresh = std::exchange(m_freshLevels, {});
    const std::vector<Image>& coarser = m_workspace.sphereMap.coarserLevels();
    for (size_t i = 0; i < std::min(fresh.size(), coarser.size()); ++i)
        if (!fresh[i].empty() && i + 1 < chain->levels.size() && coarser[i].width == chain->levels[i + 1].width)
            patch.coarser.push_back({static_cast<int>(i) + 1, fresh[i], cutOut(coarser[i], fresh[i])});
    m_thread.patch(std::move(patch));
    return true;
}

} // namespace mirrorball::studio
