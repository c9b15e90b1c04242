#include "sphere_map_editor.h"

#include <algorithm>
#include <bit>

// One level of the chain, shown and painted alone.
namespace mirrorball::studio {

namespace {

/// Whether strokes of a layer go to this level and to no other.
bool paintsOnly(const Layer& layer, int level)
{
    return layer.visible && layer.firstLevel == level && layer.lastLevel == level && std::holds_alternative<PaintLayer>(layer.content);
}

} // namespace

int SphereMapEditor::levelCount() const { return std::bit_width(static_cast<unsigned>(std::max(m_size, 1))); }

QString SphereMapEditor::onlyLevelText() const
{
    return m_onlyLevel ? tr("Level %1 only: %2 x %2").arg(*m_onlyLevel).arg(std::max(1, m_size >> *m_onlyLevel)) : QString();
}

void SphereMapEditor::showOnly(std::optional<int> level)
{
    if (level)
        level = std::clamp(*level, 0, levelCount() - 1);
    if (level == m_onlyLevel)
        return;
    cancelStroke();
    m_onlyLevel = level;
    m_levelImage = {};
    m_levelScreen = {};
    emit onlyLevelChanged();
    emit toolChanged(); // what a press of the pen does
    emit levelPictureChanged();
    if (m_onlyLevel.value_or(0) > 0)
        request();
}

/// @param average  the level where the chain is one of averages; empty: it is made by hand, and was put together from what changed of it
void SphereMapEditor::showLevel(Image average)
{
    const int level = m_onlyLevel.value_or(0);
    if (level == 0 || !m_map)
        return;
    const int size = m_size >> level;
    const auto coarser = static_cast<size_t>(level - 1);
    if (!average.empty())
        m_levelImage = std::move(average);
    else if (coarser < m_coarser.size() && m_coarser[coarser].width == size && hasAuthoredLevels(*m_map))
        m_levelImage = m_coarser[coarser];
    if (m_levelImage.width != size) // of a level that was shown before
        m_levelImage = {};
    m_levelScreen = m_levelImage.empty() ? QImage() : onScreen(m_levelImage);
    emit levelPictureChanged();
}

/// Chooses a layer whose strokes show in the level alone: the chosen one, the uppermost there is, or a new one on top.
void SphereMapEditor::prepareLevelLayer()
{
    const int level = *m_onlyLevel;
    if (const Layer* layer = chosenLayer(); layer && paintsOnly(*layer, level))
        return;
    const int count = static_cast<int>(m_map->layers.size());
    for (int i = count - 1; i >= 0; --i)
        if (paintsOnly(m_map->layers[static_cast<size_t>(i)], level)) {
            choose(i);
            return;
        }
    choose(count - 1);
    addLayer({.name = tr("Level %1").arg(level).toStdString(), .content = PaintLayer{}, .firstLevel = level, .lastLevel = level});
}

} // namespace mirrorball::studio
