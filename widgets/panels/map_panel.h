#pragma once

#include "map_view.h"
#include "widgets/controls/color_scale_bar.h"
#include "widgets/controls/number_field.h"
#include "widgets/workspace/workspace.h"

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QSplitter>
#include <QToolButton>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace mirrorball::studio {

/// The Map dock: the map of any stage in the scene's parameterization, which is chosen here, or beside another one with their difference.
class MapPanel : public QWidget {
    Q_OBJECT

public:
    enum class Stage { Probe, Specular, Diffuse, Background, Error };

    explicit MapPanel(Workspace& workspace, QWidget* parent = nullptr);

    void showStage(Stage stage);
    Stage stage() const;
    /// The view of the chosen parameterization, of the other one, and of their difference.
    MapView& view() { return *m_view; }
    MapView& otherView() { return *m_otherView; }
    MapView& differenceView() { return *m_differenceView; }
    QString readout() const { return m_readout->text(); }

    QSize sizeHint() const override { return {420, 420}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// What a stage shows now.
    struct Shown {
        std::vector<std::shared_ptr<const EnvironmentMap>> levels{};
        QString why{}; ///< why there are none
    };
    struct Comparison;

    QWidget* makeStageRow();
    QWidget* makeLayoutRow();
    QWidget* makeViewRow();
    QToolButton* makeButton(const QString& icon, const QString& text, const QString& help);
    Shown shown() const;
    QString whyLeftOut(const char* stageName) const;
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
    QComboBox* m_kind;
    QSpinBox* m_size;
    QSpinBox* m_border;
    QLabel* m_borderLabel;
    QComboBox* m_compare;
    QComboBox* m_colors;
    QComboBox* m_tint;
    QToolButton* m_grid;
    QToolButton* m_seams;
    NumberField* m_exposure;
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
