#pragma once

#include "content_form.h"
#include "layer_list.h"
#include "levels_view.h"
#include "mask_editor.h"
#include "sphere_map_canvas.h"
#include "sphere_map_form.h"
#include "widgets/controls/settings_form.h"
#include "widgets/panels/preset_gallery.h"
#include "widgets/workspace/workspace.h"

#include <QActionGroup>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>

namespace mirrorball::studio {

/// The dock "Sphere map": the disc to paint on, how the map is used, layers with their parameters, the brush, the levels, the map as a
/// whole. Without a map it offers the presets; a map that stays in its file has no layers here.
class SphereMapPanel : public QWidget {
    Q_OBJECT

public:
    explicit SphereMapPanel(Workspace& workspace, QWidget* parent = nullptr);

    SphereMapCanvas& canvas() { return *m_canvas; }
    LayerList& layers() { return *m_layers; }
    SettingsForm& layerForm() { return *m_layerForm; }
    MaskEditor& mask() { return *m_mask; }
    SettingsForm& brushForm() { return *m_brushForm; }
    LevelsView& levels() { return *m_levels; }
    SphereMapForm& mapForm() { return *m_mapForm; }
    QTabWidget& tabs() { return *m_tabs; }

    /// Takes a sphere map or a file of strokes into the scene; what is wrong with it is told by a notice.
    void openMap(const QString& path);
    void saveMapAs(const QString& path);
    /// Lets the scene name a sphere map, or a picture of one, that stays in its file.
    void linkMap(const QString& path);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeStart();
    QWidget* makeWork();
    QToolBar* makeTools();
    QWidget* makeLinked();
    QMenu* makeMapMenu(QToolButton& button);
    QWidget* makeLayersPage();
    QWidget* makeBrushPage();
    QMenu* makeKindsMenu();
    void addLayer(const LayerKind& kind);
    void askAndOpen();
    void askAndLink();
    void choosePreset(const QString& name);
    void ownLinkedMap();
    void removeMap();
    void showMap();
    void showLayer();
    void divideLayers();
    void showBrush();

    Workspace& m_workspace;
    SphereMapEditor& m_editor;
    QStackedWidget* m_pages;
    SphereMapCanvas* m_canvas = nullptr;
    QSplitter* m_split = nullptr;      ///< canvas over tabs
    bool m_splitIsChosen = false;      ///< by the user
    QSplitter* m_layerSplit = nullptr; ///< list over parameters
    bool m_layerSplitIsChosen = false;
    QWidget* m_layerTop = nullptr; ///< the list with its buttons
    QScrollArea* m_parameters = nullptr;
    size_t m_shownKind = SIZE_MAX; ///< of the layer's content
    QToolBar* m_bar = nullptr;
    QWidget* m_linked = nullptr; ///< what stands above a map that stays in its file
    QLabel* m_linkedText = nullptr;
    SphereMapForm* m_mapForm = nullptr;
    QTabWidget* m_tabs = nullptr;
    LayerList* m_layers = nullptr;
    QComboBox* m_blend = nullptr;
    NumberField* m_opacity = nullptr;
    ContentForm* m_layerForm = nullptr;
    MaskEditor* m_mask = nullptr;
    QLabel* m_layerNote = nullptr;
    SettingsForm* m_brushForm = nullptr;
    SettingsForm* m_symmetryForm = nullptr;
    ColorButton* m_color = nullptr;
    QActionGroup* m_tools = nullptr;
    LevelsView* m_levels = nullptr;
    QVector<QWidget*> m_layerControls{}; ///< need a chosen layer
};

} // namespace mirrorball::studio
