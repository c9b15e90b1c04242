#include "main_window.h"

#include "docks.h"
#include "widgets/export_dialog.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>

namespace mirrorball::studio {

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), m_preview(new PreviewWidget(m_workspace, this)), m_dropTarget(new DropTarget(*this, m_workspace))
{
    setCentralWidget(m_preview);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    addDocks();
    addActions();
    connect(&m_workspace.document, &Document::fileChanged, this, &MainWindow::showTitle);
    connect(&m_workspace.document, &Document::modifiedChanged, this, &MainWindow::setWindowModified);
    showTitle();
    resize(1440, 900);
}

// Children before the workspace that they look at.
MainWindow::~MainWindow()
{
    qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

QDockWidget* MainWindow::dock(const QString& id) const
{
    return findChild<QDockWidget*>(id);
}

void MainWindow::addDocks()
{
    for (const DockEntry& entry : dockEntries()) {
        auto* dock = new QDockWidget(QCoreApplication::translate("Docks", entry.title), this);
        dock->setObjectName(QString::fromLatin1(entry.id));
        dock->setWidget(entry.make(m_workspace));
        addDockWidget(entry.area, dock);
    }
}

void MainWindow::addActions()
{
    QMenu* file = menuBar()->addMenu(tr("&File"));
    QAction* exportMaps = file->addAction(tr("&Export maps..."));
    exportMaps->setObjectName(QStringLiteral("file.export"));
    exportMaps->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E));
    connect(exportMaps, &QAction::triggered, this, [this] {
        auto* dialog = new ExportDialog(m_workspace, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = m_workspace.document.undoStack().createUndoAction(this);
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = m_workspace.document.undoStack().createRedoAction(this);
    redo->setShortcut(QKeySequence::Redo);
    edit->addActions({undo, redo});
}

void MainWindow::showTitle()
{
    setWindowTitle(tr("%1[*] - Mirrorball Studio").arg(m_workspace.document.title()));
    setWindowFilePath(m_workspace.document.filePath());
}

} // namespace mirrorball::studio
