#include "main_window.h"

#include "command_palette.h"
#include "docks.h"
#include "panel_rest.h"
#include "theme.h"

#include "widgets/controls/image_patterns.h"
#include "widgets/controls/notice_panel.h"
#include "widgets/controls/text.h"
#include "widgets/exports/export_dialog.h"
#include "widgets/panels/plan_view.h"
#include "widgets/panels/view_panel.h"
#include "widgets/picture/model_painter.h"

#include "core/preview/mesh_file.h"
#include "core/preview/picture_file.h"

#include <QApplication>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QFileDialog>
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
      m_recovery(new Recovery(m_workspace->document, recoveryFolder, this)), m_dropTarget(new DropTarget(*this, *m_workspace))
{
    m_dropTarget->addOpener([this](const QString& path) {
        if (!FileActions::isSceneFile(path))
            return false;
        m_files->openScene(path);
        return true;
    });
    m_dropTarget->addOpener([this](const QString& path) {
        if (!preview::isMeshFile(toPath(path)))
            return false;
        useMesh(m_workspace->document, path);
        return true;
    });

    auto* middle = new QWidget(this);
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* bar = new QToolBar(tr("Picture"), middle);
    bar->setObjectName(QStringLiteral("pictureBar"));
    bar->setIconSize({20, 20});
    m_views->addTo(*bar);
    column->addWidget(bar);
    column->addWidget(new NoticePanel(m_workspace->notices, middle));
    column->addWidget(m_preview, 1);
    setCentralWidget(middle);
    new ModelPainter(*m_preview, *m_workspace); // the preview's child

    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks | GroupedDragging);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea); // the docks at the sides have the window's whole height
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    addDocks();
    addMenus();
    addStatus();
    watch();
    showTitle();
    arrange();
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
        dock->setWidget(entry.make(*m_workspace));
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

void MainWindow::addMenus()
{
    QMenu* file = menuBar()->addMenu(tr("&File"));
    m_files->addTo(*file);
    file->addSeparator();
    QAction* exportMaps = file->addAction(icon("export"), tr("&Export maps…"), this, &MainWindow::openExport);
    exportMaps->setObjectName(QStringLiteral("file.export"));
    exportMaps->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_E));
    exportMaps->setToolTip(tr("Write the maps of the scene, or copy the command line that does"));
    QAction* picture = file->addAction(icon("picture"), tr("Save &picture…"), this, &MainWindow::askAndSavePicture);
    picture->setObjectName(QStringLiteral("file.picture"));
    picture->setShortcut(QKeySequence(Qt::Key_F12));
    picture->setToolTip(tr("Save the picture as PNG, or its radiance as EXR"));
    file->addSeparator();
    QAction* quit = file->addAction(icon("close"), tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(QKeySequence::Quit);
    quit->setMenuRole(QAction::QuitRole);

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = m_workspace->document.undoStack().createUndoAction(this, tr("Undo"));
    undo->setIcon(icon("undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = m_workspace->document.undoStack().createRedoAction(this, tr("Redo"));
    redo->setIcon(icon("redo"));
    redo->setShortcuts({QKeySequence::Redo, QKeySequence(Qt::CTRL | Qt::Key_Y)});
    edit->addActions({undo, redo});
    edit->addSeparator();
    QAction* palette = edit->addAction(icon("palette"), tr("Command &palette…"), this, &MainWindow::openPalette);
    palette->setObjectName(QStringLiteral("edit.palette"));
    palette->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_P), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P)});

    QMenu* view = menuBar()->addMenu(tr("&View"));
    m_views->addTo(*view);

    m_dockMenu = menuBar()->addMenu(tr("&Window"));
    int number = 1;
    for (const DockEntry& entry : dockEntries()) {
        QAction* toggle = dock(QLatin1String(entry.id))->toggleViewAction();
        if (number <= 9)
            toggle->setShortcut(QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_0 + number++)));
        m_dockMenu->addAction(toggle);
    }
    m_dockMenu->addSeparator();
    QAction* hide = m_dockMenu->addAction(icon("docks"), tr("&Hide or show all docks"), this, &MainWindow::hideOrShowDocks);
    hide->setObjectName(QStringLiteral("window.docks"));
    hide->setShortcut(QKeySequence(Qt::Key_F9));
    hide->setToolTip(tr("Tab on the picture, F9 anywhere"));
    QAction* full = m_dockMenu->addAction(icon("fullscreen"), tr("&Full screen"), this,
                                          [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
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
    help->addAction(tr("&About Mirrorball Studio"), this,
                    [this] {
                        QMessageBox::about(this, tr("Mirrorball Studio"),
                                           tr("<b>Mirrorball Studio %1</b><p>Materials with environment maps.<p>GPL-3.0-or-later")
                                               .arg(QApplication::applicationVersion()));
                    })
        ->setMenuRole(QAction::AboutRole);
}

void MainWindow::addStatus()
{
    m_state = new QLabel(this);
    m_state->setAccessibleName(tr("State of the work"));
    m_state->setProperty("role", QStringLiteral("footnote"));
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedSize(160, 10);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->setToolTip(tr("Progress of the work in the background"));
    m_stop = new QToolButton(this);
    m_stop->setIcon(icon("stop"));
    m_stop->setAutoRaise(true);
    m_stop->setAccessibleName(tr("Stop"));
    m_stop->setToolTip(tr("Stop the work in the background (Esc)"));
    m_stop->setShortcut(QKeySequence(Qt::Key_Escape));
    statusBar()->addWidget(m_state, 1);
    statusBar()->addPermanentWidget(m_progress);
    statusBar()->addPermanentWidget(m_stop);
    statusBar()->setSizeGripEnabled(false);
    m_progress->hide();
    m_stop->hide();
    m_showProgress.setSingleShot(true);
    m_showProgress.setInterval(400);
    connect(&m_showProgress, &QTimer::timeout, this, [this] {
        m_progress->setValue(0);
        m_progress->show();
        m_stop->show();
    });
    // Each change of a widget composes the whole window anew: not once a frame.
    m_showState.setSingleShot(true);
    m_showState.setInterval(300);
    connect(&m_showState, &QTimer::timeout, this, [this] {
        if (!m_workspace->document.isDragging())
            showWork();
    });
    connect(m_stop, &QToolButton::clicked, this, [this] {
        m_workspace->live.stop();
        m_pictures.stop();
        m_state->setText(tr("Stopped"));
    });
    for (JobRunner* runner : {&m_workspace->live.runner(), &m_pictures}) {
        connect(runner, &JobRunner::busyChanged, this, &MainWindow::showWork);
        connect(runner, &JobRunner::progressed, this, [this](double fraction) {
            if (!m_progress->isHidden())
                m_progress->setValue(static_cast<int>(1000 * fraction));
        });
    }
}

void MainWindow::watch()
{
    Document& document = m_workspace->document;
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
    connect(m_preview, &PreviewWidget::painted, this, [this](auto, double seconds) {
        m_drawSeconds = seconds;
        if (!m_showState.isActive())
            m_showState.start();
    });
}

void MainWindow::showProblems()
{
    const auto made = m_workspace->live.made();
    Notices& notices = m_workspace->notices;
    notices.clear(QStringLiteral("scene"));
    notices.set(
        {.subject = QStringLiteral("probe"), .text = toQString(made->problem), .actionText = tr("Choose another…"), .action = [this] {
             const QString path = QFileDialog::getOpenFileName(this, tr("Open probe"));
             if (!path.isEmpty())
                 openFiles({path});
         }});
    notices.set({.subject = QStringLiteral("display"), .text = toQString(made->displayProblem)});
    notices.set(
        {.subject = QStringLiteral("mesh"), .text = toQString(made->meshProblem), .actionText = tr("Show the teapot"), .action = [this] {
             m_workspace->document.edit(tr("Change geometry"), {}, [](Scene& scene) { scene.view.geometry = "teapot"; });
         }});
}

void MainWindow::showWork()
{
    const bool busy = m_workspace->live.runner().isBusy() || m_pictures.isBusy();
    if (!busy) {
        m_showProgress.stop();
        m_progress->hide();
        m_stop->hide();
    } else if (!m_showProgress.isActive() && m_progress->isHidden()) {
        m_showProgress.start();
    }
    if (m_workspace->document.isDragging())
        return;
    if (m_pictures.isBusy())
        m_state->setText(tr("Saving the picture…"));
    else if (m_workspace->live.runner().isBusy() && !m_progress->isHidden())
        m_state->setText(tr("Making maps…"));
    else if (!busy && m_workspace->live.isUpToDate() && m_drawSeconds >= 0.0)
        m_state->setText(tr("Up to date. Drawn in %1 ms at %2 × %3")
                             .arg(m_drawSeconds * 1e3, 0, 'f', 0)
                             .arg(std::lround(m_preview->width() * m_preview->devicePixelRatioF()))
                             .arg(std::lround(m_preview->height() * m_preview->devicePixelRatioF())));
}

void MainWindow::arrange()
{
    // At first the window is large, but leaves a small screen's edges and a frame's title free.
    resize(QSize(1440, 900).boundedTo(screen()->availableSize() - QSize(16, 48)));
    resizeDocks({dock(QStringLiteral("probes")), dock(QStringLiteral("material"))}, {300, 340}, Qt::Horizontal);
    resizeDocks({dock(QStringLiteral("plan"))}, {height() / 5}, Qt::Vertical);
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

void MainWindow::openFiles(const QStringList& paths) { m_dropTarget->open(paths); }

void MainWindow::openExport()
{
    auto* dialog = new ExportDialog(*m_workspace, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ExportDialog::saveRequested, m_files, &FileActions::save);
    dialog->open();
}

void MainWindow::askAndSavePicture()
{
    const QString filters = tr("Display picture (%1);;Linear radiance (%2)")
                                .arg(imagePatterns(Holding::Display).join(u' '), imagePatterns(Holding::Light).join(u' '));
    QString path = QFileDialog::getSaveFileName(this, tr("Save picture"), QStringLiteral("picture.png"), filters);
    if (path.isEmpty())
        return;
    if (QFileInfo(path).suffix().isEmpty())
        path += QStringLiteral(".png");
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
