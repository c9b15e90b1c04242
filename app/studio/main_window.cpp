#include "main_window.h"

#include "command_palette.h"
#include "dock_scroll.h"
#include "docks.h"
#include "palette_entries.h"
#include "panel_rest.h"
#include "preferences_dialog.h"
#include "theme.h"
#include "work_status.h"

#include "help/guide.h"

#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/image_patterns.h"
#include "widgets/controls/notice_panel.h"
#include "widgets/controls/text.h"
#include "widgets/exports/export_dialog.h"
#include "widgets/files/doctor_dialog.h"
#include "widgets/files/picture_question.h"
#include "widgets/panels/plan_view.h"
#include "widgets/panels/view_panel.h"
#include "widgets/picture/model_painter.h"
#include "widgets/spheremap/sphere_map_panel.h"

#include "core/preview/picture_file.h"

#include <QApplication>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace mirrorball::studio {

namespace {

constexpr int layoutVersion = 2; ///< counts up when docks change so much that an old layout does not fit

} // namespace

MainWindow::MainWindow(const QString& recoveryFolder, QWidget* parent)
    : QMainWindow(parent), m_workspace(std::make_unique<Workspace>()), m_preview(new PreviewWidget(*m_workspace)),
      m_files(new FileActions(*this, *m_workspace)), m_views(new ViewActions(*m_preview, *m_workspace, this)),
      m_recovery(new Recovery(m_workspace->document, recoveryFolder, this)), m_dropTarget(new DropTarget(*this, m_files->opener())),
      m_edits(new EditActions(*this, *m_workspace, m_files->opener(), *m_preview)), m_tour(new Tour(*m_workspace)),
      m_help(new HelpActions(*this, *m_tour))
{
    auto* middle = new QWidget(this);
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* bar = new QToolBar(tr("Picture"), middle);
    bar->setObjectName(QStringLiteral("pictureBar"));
    bar->setIconSize({20, 20});
    m_views->addTo(*bar);
    m_views->addKeysTo(*middle);
    column->addWidget(bar);
    column->addWidget(new NoticePanel(m_workspace->notices, middle));
    column->addWidget(m_tour);
    column->addWidget(m_preview, 1);
    setCentralWidget(middle);
    new ModelPainter(*m_preview, *m_workspace); // the preview's child
    setHelpPage(*middle, QStringLiteral("studio.md"));
    m_preview->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_preview, &QWidget::customContextMenuRequested, this, &MainWindow::showPictureMenu);

    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks | GroupedDragging);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea); // the docks at the sides have the window's whole height
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    addDocks();
    addOpening();
    addMenus();
    m_keys = new CommandKeys(*this, *middle);
    new WorkStatus(*statusBar(), *m_workspace, *m_preview, m_pictures); // the bar's child
    watch();
    showTitle();
    arrange();
    m_preview->setFocus(); // its keys are the ones that the guide begins with
    offerRecovery();
}

// Widgets before the workspace that they look at.
MainWindow::~MainWindow()
{
    qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    delete m_recovery;
}

QDockWidget* MainWindow::dock(const QString& id) const { return findChild<QDockWidget*>(id); }

void MainWindow::addDocks()
{
    for (const DockEntry& entry : dockEntries()) {
        auto* dock = new QDockWidget(QCoreApplication::translate("Docks", entry.title), this);
        dock->setObjectName(QString::fromLatin1(entry.id));
        dock->setAccessibleName(dock->windowTitle());
        dock->setWidget(new DockScroll(*entry.make(*m_workspace)));
        setHelpPage(*dock, QLatin1String(entry.page));
        dock->toggleViewAction()->setIcon(icon(entry.icon));
        addDockWidget(entry.area, dock);
        new PanelRest(*dock);
    }
    for (const DockTabs& tabs : dockTabs()) {
        tabifyDockWidget(dock(QLatin1String(tabs.front)), dock(QLatin1String(tabs.behind)));
        dock(QLatin1String(tabs.front))->raise();
    }
    if (auto* plan = findChild<PlanView*>())
        connect(m_preview, &PreviewWidget::painted, plan, [plan](auto, double seconds) { plan->setDrawTime(seconds); });
}

/// What becomes of files: where drops land, what is asked, what comes to the front.
void MainWindow::addOpening()
{
    FileOpener& opener = m_files->opener();
    opener.setQuestion([this](const QString& path) {
        auto* question = new PictureQuestion(*m_workspace, path, this);
        connect(question, &PictureQuestion::chosen, this,
                [this, path](PictureUse use, const ProbeReading& reading) { m_files->opener().usePicture(path, use, reading); });
        m_help->serve(*question, QStringLiteral("files.md"));
        question->open();
    });
    connect(&opener, &FileOpener::opened, this, [this](const QString& path, FileKind kind) {
        if (kind == FileKind::SphereMap) // its layers are what it was opened for
            dock(QStringLiteral("sphere-map"))->raise();
        if (kind == FileKind::Picture)
            offerDoctor(path);
    });
    auto* panel = findChild<SphereMapPanel*>();
    m_dropTarget->addPlace(*m_preview, [panel] { return panel->isVisible() ? DropPlace::BesideSphereMap : DropPlace::Elsewhere; });
    m_dropTarget->addPlace(*panel, [] { return DropPlace::SphereMap; });
    m_dropTarget->addPlace(panel->canvas(), [] { return DropPlace::SphereMap; });
    m_dropTarget->addPlace(panel->layers().list(), [] { return DropPlace::Layers; });
    m_dropTarget->setPictureKeeper([this](const QImage& picture) { return m_edits->keep(picture); });
}

/// A file of several levels may be a map that someone filtered.
void MainWindow::offerDoctor(const QString& path)
{
    const std::optional<PictureFacts> facts = pictureFacts(path);
    const bool hasLevels = facts && facts->levels > 1;
    m_workspace->notices.set(
        {.subject = QStringLiteral("doctor"),
         .text =
             hasLevels
                 ? tr("%1 holds %2 levels: it may be a map that was filtered already.").arg(QFileInfo(path).fileName()).arg(facts->levels)
                 : QString(),
         .actionText = tr("What is this map?"),
         .action = [this, path] {
             m_workspace->notices.clear(QStringLiteral("doctor"));
             askDoctor(path);
         }});
}

void MainWindow::askDoctor(const QString& path)
{
    auto* doctor = new DoctorDialog(*m_workspace, path, this);
    m_help->serve(*doctor, QStringLiteral("doctor.md"));
    doctor->open();
}

/// Brings a dock to the front where it is closed or behind a tab, and closes it where it is seen.
QAction* MainWindow::makeDockAction(QDockWidget& dock)
{
    auto* action = new QAction(dock.toggleViewAction()->icon(), dock.windowTitle(), this);
    action->setObjectName(QStringLiteral("window.") + dock.objectName());
    action->setToolTip(tr("Brings the dock to the front, or closes it where it is there"));
    action->setCheckable(true);
    action->setChecked(!dock.isHidden());
    connect(dock.toggleViewAction(), &QAction::toggled, action, &QAction::setChecked);
    connect(action, &QAction::triggered, this, [&dock, action] {
        const bool isSeen = !dock.isHidden() && dock.widget()->isVisible();
        dock.setVisible(!isSeen);
        if (!isSeen)
            dock.raise();
        action->setChecked(!isSeen);
    });
    return action;
}

void MainWindow::addMenus()
{
    QMenu* file = menuBar()->addMenu(tr("&File"));
    m_files->addTo(*file);
    file->addSeparator();
    QAction* exportMaps = file->addAction(icon("export"), tr("&Export maps…"), this, &MainWindow::openExport);
    exportMaps->setObjectName(QStringLiteral("file.export"));
    exportMaps->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_E));
    exportMaps->setToolTip(tr("Write the maps of the scene, or copy the command line that does"));
    QAction* doctor = file->addAction(icon("report"), tr("&What is this map?…"), this, [this] {
        const QString path =
            askForFile(this, {.purpose = QStringLiteral("open"), .title = tr("What is this map?"), .filter = filterOf(FileKind::Picture)});
        if (!path.isEmpty())
            askDoctor(path);
    });
    doctor->setObjectName(QStringLiteral("file.doctor"));
    doctor->setToolTip(tr("Tell what a prefiltered map of anyone is: orientation, roughness law, lobe, scale, errors and faults"));
    QAction* picture = file->addAction(icon("picture"), tr("Save &picture…"), this, &MainWindow::askAndSavePicture);
    picture->setObjectName(QStringLiteral("file.picture"));
    picture->setShortcut(QKeySequence(Qt::Key_F12));
    picture->setToolTip(tr("Save the picture as PNG, or its radiance as EXR"));
    file->addSeparator();
    QAction* quit = file->addAction(icon("close"), tr("&Quit"), this, &QWidget::close);
    quit->setObjectName(QStringLiteral("file.quit"));
    quit->setShortcut(QKeySequence::Quit);
    quit->setMenuRole(QAction::QuitRole);

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    m_edits->addTo(*edit);
    edit->addSeparator();
    QAction* palette = edit->addAction(icon("palette"), tr("Command &palette…"), this, &MainWindow::openPalette);
    palette->setObjectName(QStringLiteral("edit.palette"));
    palette->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_P), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P)});

    QAction* preferences = edit->addAction(icon("view"), tr("P&references…"), this, &MainWindow::openPreferences);
    preferences->setObjectName(QStringLiteral("edit.preferences"));
    preferences->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Comma));
    preferences->setToolTip(tr("Keys of commands, drags in the picture, how soon unsaved changes are kept"));
    preferences->setMenuRole(QAction::PreferencesRole);

    QMenu* view = menuBar()->addMenu(tr("&View"));
    m_views->addTo(*view);

    m_dockMenu = menuBar()->addMenu(tr("&Window"));
    int number = 1;
    for (const DockEntry& entry : dockEntries()) {
        QAction* raise = makeDockAction(*dock(QLatin1String(entry.id)));
        if (number <= 9)
            raise->setShortcut(QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_0 + number++)));
        m_dockMenu->addAction(raise);
    }
    m_dockMenu->addSeparator();
    QAction* hide = m_dockMenu->addAction(icon("docks"), tr("&Hide or show all docks"), this, &MainWindow::hideOrShowDocks);
    hide->setObjectName(QStringLiteral("window.docks"));
    hide->setShortcut(QKeySequence(Qt::Key_F9));
    hide->setToolTip(tr("Tab on the picture, F9 anywhere"));
    QAction* full = m_dockMenu->addAction(icon("fullscreen"), tr("&Full screen"), this,
                                          [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    full->setObjectName(QStringLiteral("window.full"));
    full->setShortcut(QKeySequence(Qt::Key_F11));
    m_dockMenu->addAction(icon("layout"), tr("&Reset layout"), this, &MainWindow::resetLayout)
        ->setObjectName(QStringLiteral("window.reset"));

    // Tab walks through controls everywhere but on the picture, which has none.
    auto* onPicture = new QAction(hide->text(), m_preview);
    onPicture->setShortcut(QKeySequence(Qt::Key_Tab));
    onPicture->setShortcutContext(Qt::WidgetShortcut);
    connect(onPicture, &QAction::triggered, this, &MainWindow::hideOrShowDocks);
    m_preview->addAction(onPicture);

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    m_help->addTo(*help);
}

void MainWindow::watch()
{
    Document& document = m_workspace->document;
    connect(m_views, &ViewActions::said, this, [this](const QString& text) { statusBar()->showMessage(text, 4000); });
    connect(m_tour, &Tour::showRequested, this, &MainWindow::showPlace);
    connect(&document, &Document::fileChanged, this, &MainWindow::showTitle);
    connect(&document, &Document::modifiedChanged, this, &MainWindow::setWindowModified);
    connect(&document, &Document::refused, this,
            [this](const QString& message) { m_workspace->notices.set({.subject = QStringLiteral("edit"), .text = message}); });
    connect(&document, &Document::changed, this, [this] { m_workspace->notices.clear(QStringLiteral("edit")); });
    connect(&m_workspace->live, &LiveScene::updated, this, &MainWindow::showProblems);
    connect(&m_workspace->live, &LiveScene::failed, this,
            [this](const QString& message) { m_workspace->notices.set({.subject = QStringLiteral("scene"), .text = message}); });
    connect(&m_pictures, &JobRunner::failed, this,
            [this](const QString& message) { m_workspace->notices.set({.subject = QStringLiteral("picture"), .text = message}); });
}

void MainWindow::showProblems()
{
    const auto made = m_workspace->live.made();
    Notices& notices = m_workspace->notices;
    notices.clear(QStringLiteral("scene"));
    notices.set(
        {.subject = QStringLiteral("probe"), .text = toQString(made->problem), .actionText = tr("Choose another…"), .action = [this] {
             openFiles(
                 askForFiles(this, {.purpose = QStringLiteral("open"), .title = tr("Open probe"), .filter = filterOf(FileKind::Picture)}));
         }});
    notices.set({.subject = QStringLiteral("display"), .text = toQString(made->displayProblem)});
    notices.set(
        {.subject = QStringLiteral("mesh"), .text = toQString(made->meshProblem), .actionText = tr("Show the teapot"), .action = [this] {
             m_workspace->document.edit(tr("Change geometry"), {}, [](Scene& scene) { scene.view.geometry = "teapot"; });
         }});
}

void MainWindow::arrange()
{
    // At first the window is large, but leaves a small screen's edges and a frame's title free.
    resize(QSize(1440, 900).boundedTo(screen()->availableSize() - QSize(16, 48)));
    resizeDocks({dock(QStringLiteral("probes")), dock(QStringLiteral("material"))}, {314, 340}, Qt::Horizontal);
    resizeDocks({dock(QStringLiteral("plan"))}, {height() / 5}, Qt::Vertical);
    resizeDocks({dock(QStringLiteral("probes")), dock(QStringLiteral("map"))}, {2 * height() / 5, 3 * height() / 5}, Qt::Vertical);
    m_firstLayout = saveState(layoutVersion);
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/layout")).toByteArray(), layoutVersion);
}

void MainWindow::resetLayout()
{
    m_hiddenDocks.clear();
    restoreState(m_firstLayout, layoutVersion);
}

void MainWindow::hideOrShowDocks()
{
    QList<QDockWidget*> shown;
    for (QDockWidget* each : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (!each->isHidden())
            shown << each;
    if (!shown.isEmpty()) {
        m_hiddenDocks = shown;
        for (QDockWidget* each : shown)
            each->hide();
        m_preview->setFocus();
        return;
    }
    for (QDockWidget* each : m_hiddenDocks.isEmpty() ? findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly) : m_hiddenDocks)
        each->show();
    m_hiddenDocks.clear();
}

void MainWindow::openPalette()
{
    auto* palette = new CommandPalette(*this);
    palette->show();
}

void MainWindow::openFiles(const QStringList& paths) { m_files->opener().open(paths); }

void MainWindow::openExport()
{
    auto* dialog = new ExportDialog(*m_workspace, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ExportDialog::saveRequested, m_files, &FileActions::save);
    connect(dialog, &ExportDialog::exported, m_tour, &Tour::noteExport);
    m_help->serve(*dialog, QStringLiteral("engines.md"));
    dialog->open();
}

void MainWindow::openPreferences()
{
    auto* dialog = new PreferencesDialog(*m_keys, *m_recovery, *this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_help->serve(*dialog, QStringLiteral("studio.md"));
    dialog->open();
}

void MainWindow::greet() { m_tour->greet(); }

// A right drag may turn the light, or change the brush.
void MainWindow::showPictureMenu(const QPoint& position)
{
    if (QApplication::keyboardModifiers() != Qt::NoModifier || m_workspace->sphereMap.paintsOnModel())
        return;
    QList<QAction*> others;
    for (const char* name : {"edit.copy", "file.picture", "file.export"})
        others << findChild<QAction*>(QLatin1String(name));
    m_views->popUp(m_preview->mapToGlobal(position), others);
}

void MainWindow::showPlace(const QString& id, const QString& control)
{
    QDockWidget* place = dock(id);
    auto* wanted = place ? place->findChild<QWidget*>(control) : nullptr;
    if (wanted)
        showControl(*wanted);
    else
        openExport();
}

void MainWindow::askAndSavePicture()
{
    const QString filters = tr("Display picture (%1);;Linear radiance (%2)")
                                .arg(imagePatterns(Holding::Display).join(u' '), imagePatterns(Holding::Light).join(u' '));
    const QString ending = QStringLiteral(".png");
    const QString path =
        askWhereToSave(
            this, {.purpose = QStringLiteral("picture"), .title = tr("Save picture"), .filter = filters, .start = tr("picture") + ending},
            ending)
            .path;
    if (!path.isEmpty())
        savePicture(path);
}

void MainWindow::savePicture(const QString& path)
{
    m_pictures.start(
        [scene = m_workspace->document.scene(), path = toPath(path)](const JobControl& job) {
            preview::savePicture(planScene(scene), path, job);
            return path;
        },
        [this](const std::filesystem::path& written) {
            m_workspace->notices.clear(QStringLiteral("picture"));
            statusBar()->showMessage(tr("Saved %1").arg(fromPath(written)), 4000);
        });
}

void MainWindow::offerRecovery()
{
    const std::vector<Recovery::Found> found = m_recovery->found();
    if (found.empty())
        return;
    const Recovery::Found newest = found.front();
    const QString name = newest.original.isEmpty() ? tr("a scene without a file") : newest.original;
    m_workspace->notices.set({.subject = QStringLiteral("recovery"),
                              .text = tr("Mirrorball ended before %1 was saved. Its changes of %2 were kept.")
                                          .arg(name, QLocale().toString(newest.time, QLocale::ShortFormat)),
                              .actionText = tr("Restore"),
                              .action = [this, newest] {
                                  if (!m_files->mayGoOn())
                                      return;
                                  m_recovery->restore(newest);
                                  m_workspace->notices.clear(QStringLiteral("recovery"));
                                  offerRecovery();
                              }});
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files->mayGoOn()) {
        event->ignore();
        return;
    }
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/layout"), saveState(layoutVersion));
    event->accept();
}

void MainWindow::showTitle()
{
    setWindowTitle(tr("%1[*] - Mirrorball Studio").arg(m_workspace->document.title()));
    setWindowFilePath(m_workspace->document.filePath());
    setWindowModified(m_workspace->document.isModified());
}

} // namespace mirrorball::studio
