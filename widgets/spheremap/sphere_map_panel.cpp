#include "sphere_map_panel.h"

#include "brush_page.h"
#include "sphere_map_source_field.h"
#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/icon_button.h"
#include "widgets/controls/scrolled.h"
#include "widgets/controls/text.h"
#include "widgets/exports/painted_export.h"
#include "widgets/files/recent_files.h"
#include "widgets/files/use_file.h"

#include "core/base/error.h"
#include "core/scene/sphere_map_source.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace mirrorball::studio {

namespace {

const QString noticeSubject = QStringLiteral("sphere-map");

/// What a new sphere map begins with: a ground to see the model by, and a layer to paint on.
SphereMapDocument freshMap()
{
    SphereMapDocument map;
    map.title = "Untitled";
    map.layers = {{.name = "Ground", .content = GradientLayer{}}, {.name = "Paint", .content = PaintLayer{}}};
    return map;
}

} // namespace

SphereMapPanel::SphereMapPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_editor(workspace.sphereMap), m_pages(new QStackedWidget(this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_pages);
    m_pages->addWidget(makeStart());
    m_pages->addWidget(makeWork());
    connect(&m_editor, &SphereMapEditor::mapChanged, this, &SphereMapPanel::showMap);
    connect(&m_workspace.document, &Document::changed, this, [this](Parts parts) {
        if (parts.testFlag(Part::Material) && !m_editor.map())
            showMap();
    });
    connect(&m_editor, &SphereMapEditor::problemChanged, this,
            [this](const QString& problem) { m_workspace.notices.set({.subject = noticeSubject, .text = problem}); });
    showMap();
}

// ---- without a map -------------------------------------------------------------------------------------------------------------

QWidget* SphereMapPanel::makeStart()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(12, 12, 12, 10);
    column->setSpacing(8);
    auto* text =
        new QLabel(tr("A sphere map paints the look of the material by hand: one picture of a ball, in layers, shown live on the model."));
    text->setWordWrap(true);
    const auto choice = [this](const char* object, const QString& name, const QString& help, auto act) {
        auto* made = new QPushButton(name);
        made->setObjectName(QLatin1String(object));
        made->setAccessibleName(name);
        made->setToolTip(help);
        connect(made, &QPushButton::clicked, this, act);
        return made;
    };
    QPushButton* fresh = choice("newSphereMap", tr("New sphere map"), tr("Give the material a sphere map of its own, to paint and layer"),
                                [this] { m_editor.setMap(tr("New sphere map"), freshMap()); });
    fresh->setDefault(true);
    auto* files = new QHBoxLayout;
    files->setSpacing(6);
    files->addWidget(choice("openSphereMap", tr("Open a file..."), tr("Copy a sphere map or recorded strokes from a file into the scene"),
                            [this] { askAndOpen(); }));
    files->addWidget(choice("linkSphereMap", tr("Link a file..."),
                            tr("Show a sphere map, or a picture of one, that stays in its file and follows it"), [this] { askAndLink(); }));
    auto* heading = new QLabel(tr("Start from a preset"));
    heading->setProperty("role", QStringLiteral("heading"));
    auto* gallery = new PresetGallery(m_workspace.presets);
    connect(gallery, &PresetGallery::chosen, this, &SphereMapPanel::choosePreset);
    column->addWidget(text);
    column->addWidget(fresh);
    column->addLayout(files);
    column->addWidget(heading);
    column->addWidget(gallery, 1);
    return page;
}

void SphereMapPanel::askAndOpen()
{
    const QString path =
        askForFile(this, {.purpose = QStringLiteral("open"), .title = tr("Open a sphere map"), .filter = filterOf(FileKind::SphereMap)});
    if (!path.isEmpty())
        openMap(path);
}

void SphereMapPanel::askAndLink()
{
    const QString path =
        askForFile(this, {.purpose = QStringLiteral("open"), .title = tr("Link a sphere map"), .filter = sphereMapFileFilter()});
    if (!path.isEmpty())
        linkMap(path);
}

void SphereMapPanel::choosePreset(const QString& name)
{
    if (const SphereMapPreset* preset = findSphereMapPreset(name.toStdString()))
        m_editor.setMap(tr("Choose a sphere map"), preset->document);
}

void SphereMapPanel::linkMap(const QString& path) { linkSphereMap(m_workspace, path); }

// What the scene names becomes a part of it; a picture becomes an image layer.
void SphereMapPanel::ownLinkedMap()
{
    const Scene& scene = m_workspace.document.scene();
    const std::string source = scene.material.sphereMap.source;
    if (!isSphereMapFile(source)) {
        choosePreset(toQString(source));
        return;
    }
    const QString path = toQString(resolved(scene, source));
    if (path.endsWith(QStringLiteral(".spheremap"))) {
        openMap(path);
        return;
    }
    SphereMapDocument map;
    map.title = QFileInfo(path).completeBaseName().toStdString();
    map.layers = {{.name = map.title, .content = ImageLayer{.source = path.toStdString(), .inset = 0.0}}};
    m_editor.setMap(tr("Open a sphere map"), map);
}

void SphereMapPanel::removeMap()
{
    m_workspace.document.edit(tr("Remove the sphere map"), {}, [](Scene& scene) {
        scene.material.sphereMap.document = {};
        scene.material.sphereMap.source.clear();
    });
}

void SphereMapPanel::openMap(const QString& path) { useSphereMap(m_workspace, path); }

void SphereMapPanel::saveMapAs(const QString& path)
{
    if (!m_editor.map())
        return;
    try {
        saveSphereMap(*m_editor.map(), toPath(path));
        rememberRecent(path, FileKind::SphereMap);
        m_workspace.notices.clear(noticeSubject);
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = noticeSubject, .text = QString::fromUtf8(error.what())});
    }
}

// ---- with a map ----------------------------------------------------------------------------------------------------------------

QWidget* SphereMapPanel::makeWork()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_bar = makeTools();
    column->addWidget(m_bar);
    m_linked = makeLinked();
    column->addWidget(m_linked);
    m_canvas = new SphereMapCanvas(m_editor);
    m_tabs = new QTabWidget;
    m_tabs->setDocumentMode(true);
    m_tabs->setObjectName(QStringLiteral("sphereMapTabs"));
    m_layers = new LayersPage(m_editor);
    m_tabs->addTab(m_layers, tr("Layers"));
    m_tabs->addTab(scrolled(new BrushPage(m_editor)), tr("Brush"));
    m_levels = new LevelsView(m_editor);
    m_tabs->addTab(m_levels, tr("Levels"));
    m_mapForm = new SphereMapForm(m_workspace);
    m_tabs->addTab(scrolled(m_mapForm), tr("Map"));
    for (const auto& [tab, help] : {std::pair{0, tr("What the map is made of")},
                                    {1, tr("What is painted with")},
                                    {2, tr("The mip chain, level by level")},
                                    {3, tr("How the map is looked up, its size, flecks, and what it is called")}})
        m_tabs->setTabToolTip(tab, help);
    auto* below = new QWidget;
    auto* belowColumn = new QVBoxLayout(below);
    belowColumn->setContentsMargins(0, 0, 0, 0);
    belowColumn->setSpacing(4);
    belowColumn->addWidget(new SphereMapUseRow(m_workspace.document));
    belowColumn->addWidget(m_tabs, 1);
    m_split = new QSplitter(Qt::Vertical);
    m_split->addWidget(m_canvas);
    m_split->addWidget(below);
    m_split->setStretchFactor(0, 0);
    m_split->setStretchFactor(1, 1);
    m_split->setChildrenCollapsible(false);
    connect(m_split, &QSplitter::splitterMoved, this, [this] { m_splitIsChosen = true; });
    column->addWidget(m_split, 1);
    return page;
}

/// A disc in a dock is as high as it is wide, where that leaves enough for the layers; until the user divides the dock otherwise.
void SphereMapPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    QMetaObject::invokeMethod(m_layers, &LayersPage::divide, Qt::QueuedConnection); // when what is inside has its new size
    if (m_splitIsChosen)
        return;
    const int canvas = std::min(width(), 36 * height() / 100);
    m_split->setSizes({canvas, height() - canvas});
}

/// A map that stays in its file can be used, not changed.
QWidget* SphereMapPanel::makeLinked()
{
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(10, 10, 10, 4);
    m_linkedText = new QLabel;
    m_linkedText->setWordWrap(true);
    auto* own = new QPushButton(tr("Edit a copy"));
    own->setObjectName(QStringLiteral("ownSphereMap"));
    own->setAccessibleName(own->text());
    own->setToolTip(tr("Copy it into the scene, to paint and layer"));
    connect(own, &QPushButton::clicked, this, &SphereMapPanel::ownLinkedMap);
    auto* remove = new QPushButton(tr("Remove"));
    remove->setObjectName(QStringLiteral("unlinkSphereMap"));
    remove->setAccessibleName(tr("Remove the sphere map"));
    remove->setToolTip(tr("Show the material without a sphere map"));
    connect(remove, &QPushButton::clicked, this, &SphereMapPanel::removeMap);
    auto* row = new QHBoxLayout;
    row->addWidget(own);
    row->addWidget(remove);
    row->addStretch(1);
    column->addWidget(m_linkedText);
    column->addLayout(row);
    return box;
}

PaintTools* SphereMapPanel::makeTools()
{
    auto* bar = new PaintTools(m_editor);
    connect(bar, &PaintTools::moreSymmetriesWanted, this, [this] { m_tabs->setCurrentIndex(1); });
    auto* spacer = new QWidget;
    spacer->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(spacer);
    QAction* fit = bar->addAction(iconOf("frame"), tr("Fit"));
    fit->setToolTip(tr("Show the whole disc (Home)"));
    connect(fit, &QAction::triggered, this, [this] { m_canvas->fit(); });
    auto* more = iconButton("more", tr("Sphere map"), tr("New, presets, open, save, remove"));
    more->setPopupMode(QToolButton::InstantPopup);
    more->setMenu(makeMapMenu(*more));
    bar->addWidget(more);
    return bar;
}

QMenu* SphereMapPanel::makeMapMenu(QToolButton& button)
{
    auto* menu = new QMenu(this);
    connect(menu->addAction(tr("New sphere map")), &QAction::triggered, this,
            [this] { m_editor.setMap(tr("New sphere map"), freshMap()); });
    connect(menu->addAction(tr("Presets...")), &QAction::triggered, this, [this, &button] {
        connect(openPresetGallery(m_workspace.presets, button), &PresetGallery::chosen, this, &SphereMapPanel::choosePreset);
    });
    connect(menu->addAction(tr("Open...")), &QAction::triggered, this, &SphereMapPanel::askAndOpen);
    connect(menu->addAction(tr("Link a file...")), &QAction::triggered, this, &SphereMapPanel::askAndLink);
    connect(menu->addAction(tr("Save a copy...")), &QAction::triggered, this, [this] {
        const QString path =
            askWhereToSave(
                this, {.purpose = QStringLiteral("save"), .title = tr("Save the sphere map"), .filter = tr("Sphere maps (*.spheremap)")},
                QStringLiteral(".spheremap"))
                .path;
        if (!path.isEmpty())
            saveMapAs(path.endsWith(QStringLiteral(".spheremap")) ? path : path + QStringLiteral(".spheremap"));
    });
    auto* picture = new PaintedExport(m_workspace, this);
    connect(menu->addAction(tr("Export the picture...")), &QAction::triggered, picture, &PaintedExport::askAndWrite);
    menu->addSeparator();
    connect(menu->addAction(tr("Remove the sphere map")), &QAction::triggered, this, &SphereMapPanel::removeMap);
    return menu;
}

void SphereMapPanel::showMap()
{
    const SphereMapSettings& settings = m_workspace.document.scene().material.sphereMap;
    const bool isOwn = m_editor.map() != nullptr;
    m_pages->setCurrentIndex(settings.isNone() ? 0 : 1);
    m_bar->setVisible(isOwn);
    m_canvas->setVisible(isOwn);
    m_linked->setVisible(!isOwn);
    m_linkedText->setText(isSphereMapFile(settings.source)
                              ? tr("The material shows %1, which stays in its file.").arg(toQString(settings.source))
                              : tr("The material shows the preset %1.").arg(toQString(settings.source)));
    const bool isNewlyOwn = isOwn && !m_tabs->isTabVisible(0);
    for (int tab = 0; tab < m_tabs->count() - 1; ++tab)
        m_tabs->setTabVisible(tab, isOwn);
    if (isNewlyOwn)
        m_tabs->setCurrentIndex(0); // hiding the others has chosen the last
}

} // namespace mirrorball::studio
