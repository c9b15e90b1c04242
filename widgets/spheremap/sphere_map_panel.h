#pragma once

#include "layers_page.h"
#include "levels_view.h"
#include "paint_tools.h"
#include "sphere_map_canvas.h"
#include "sphere_map_form.h"
#include "widgets/panels/preset_gallery.h"
#include "widgets/workspace/workspace.h"

#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>

namespace mirrorball::studio {

/// The dock "Sphere map": the disc to paint on, how the map is used, layers with their parameters, the brush, the levels, the map as a
/// whole. Without a map it offers the presets; a map that stays in its file has no layers here.
class SphereMapPanel : public QWidget {
    Q_OBJECT

public:
    explicit SphereMapPanel(Workspace& workspace, QWidget* parent = nullptr);

    SphereMapCanvas& canvas() { return *m_canvas; }
    LayersPage& layers() { return *m_layers; }
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
    PaintTools* makeTools();
    QWidget* makeLinked();
    QMenu* makeMapMenu(QToolButton& button);
    void askAndOpen();
    void askAndLink();
    void choosePreset(const QString& name);
    void ownLinkedMap();
    void removeMap();
    void showMap();

    Workspace& m_workspace;
    SphereMapEditor& m_editor;
    QStackedWidget* m_pages;
    SphereMapCanvas* m_canvas = nullptr;
    QSplitter* m_split = nullptr; ///< canvas over tabs
    bool m_splitIsChosen = false; ///< by the user
    PaintTools* m_bar = nullptr;
    QWidget* m_linked = nullptr; ///< what stands above a map that stays in its file
    QLabel* m_linkedText = nullptr;
    SphereMapForm* m_mapForm = nullptr;
    QTabWidget* m_tabs = nullptr;
    LayersPage* m_layers = nullptr;
    LevelsView* m_levels = nullptr;
};

} // namespace mirrorball::studio
