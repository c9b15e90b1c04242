#pragma once

#include "map_layout_row.h"
#include "map_look.h"
#include "map_stage.h"
#include "map_view.h"
#include "widgets/controls/color_scale_bar.h"
#include "widgets/workspace/workspace.h"

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QSplitter>
#include <QWidget>

#include <memory>

namespace mirrorball::studio {

/// The Map dock: the map of any stage in the scene's parameterization, which is chosen here, or beside another one with their difference.
class MapPanel : public QWidget {
    Q_OBJECT

public:
    explicit MapPanel(Workspace& workspace, QWidget* parent = nullptr);

    void showStage(MapStage stage);
    MapStage stage() const;
    /// The view of the chosen parameterization, of the other one, and of their difference.
    MapView& view() { return *m_view; }
    MapView& otherView() { return *m_otherView; }
    MapView& differenceView() { return *m_differenceView; }
    QString readout() const { return m_readout->text(); }

    QSize sizeHint() const override { return {420, 420}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeStageRow();
    MapLayout layoutFor(const EnvironmentMap& map) const;
    void readScene();
    void showMaps();
    void showComparison();
    void applyColors();
    void applyOverlays();
    void showMenu(MapView& view, const QPoint& position);
    void showReadout();
    void showFacts();

    Workspace& m_workspace;
    JobRunner m_compareRunner;
    QComboBox* m_stage;
    QSpinBox* m_level;
    QLabel* m_levelOf;
    MapLayoutRow* m_layoutRow;
    MapLook* m_look;
    QSplitter* m_views;
    MapView *m_view, *m_otherView, *m_differenceView;
    ColorScaleBar *m_scale, *m_differenceScale, *m_tintScale;
    QLabel *m_readout, *m_facts;
    std::shared_ptr<const EnvironmentMap> m_map;     ///< in m_view
    std::shared_ptr<const EnvironmentMap> m_rangeOf; ///< that m_range was measured on
    LuminanceRange m_range{};
    double m_differenceRange = 1.0;
    QString m_comparisonFacts;
};

} // namespace mirrorball::studio
