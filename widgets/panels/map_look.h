#pragma once

#include "map_view.h"
#include "widgets/controls/number_field.h"

#include <QComboBox>
#include <QMenu>
#include <QToolButton>
#include <QWidget>

namespace mirrorball::studio {

/// How the Map dock draws its maps: their colors and brightness, and what lies over them. None of it is of the scene.
class MapLook : public QWidget {
    Q_OBJECT

public:
    explicit MapLook(QWidget* parent = nullptr);

    MapColors colors() const;
    /// Colors are the user's to choose but for a signed error, which has its own.
    void setColorsEnabled(bool enabled) { m_colors->setEnabled(enabled); }
    /// In EV.
    double exposure() const { return m_exposure->value(); }
    MapOverlays overlays() const;
    /// The overlays that are switched on and off, as entries of a menu.
    void addOverlays(QMenu& menu) const;

signals:
    /// colors() or exposure() changed.
    void colorsChanged();
    void overlaysChanged();
    /// The whole map is wanted in sight.
    void fitWanted();

private:
    QComboBox *m_colors, *m_tint;
    QToolButton *m_grid, *m_seams;
    NumberField* m_exposure;
};

} // namespace mirrorball::studio
