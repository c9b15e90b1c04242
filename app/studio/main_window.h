#pragma once

#include "file_actions.h"
#include "recovery.h"
#include "view_actions.h"

#include "widgets/controls/drop_target.h"
#include "widgets/picture/preview_widget.h"
#include "widgets/workspace/workspace.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QProgressBar>
#include <QToolButton>

#include <memory>

namespace mirrorball::studio {

/// The window of one document: the preview in the middle, docks around it.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// @param recoveryFolder where copies of unsaved changes go
    explicit MainWindow(const QString& recoveryFolder = Recovery::defaultFolder(), QWidget* parent = nullptr);
    ~MainWindow() override;

    Workspace& workspace() { return *m_workspace; }
    PreviewWidget& preview() { return *m_preview; }
    FileActions& files() { return *m_files; }
    Recovery& recovery() { return *m_recovery; }
    DropTarget& dropTarget() { return *m_dropTarget; }
    /// The dock of that id (docks.h), or null.
    QDockWidget* dock(const QString& id) const;

    /// Opens files as if they were dropped: a scene, a mesh, a probe, a folder of probes.
    void openFiles(const QStringList& paths);
    /// Draws the picture at its own size into a file, in the background.
    void savePicture(const QString& path);

public slots:
    void hideOrShowDocks();
    void resetLayout();
    void openPalette();
    void openExport();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void addDocks();
    void addMenus();
    void addStatus();
    void arrange();
    void watch();
    void offerRecovery();
    void askAndSavePicture();
    void showTitle();
    void showProblems();
    void showWork();

    std::unique_ptr<Workspace> m_workspace; ///< goes after the widgets that look at it
    JobRunner m_pictures;                   ///< draws pictures into files
    PreviewWidget* m_preview;
    FileActions* m_files;
    ViewActions* m_views;
    Recovery* m_recovery;
    DropTarget* m_dropTarget;
    QMenu* m_dockMenu = nullptr;
    QLabel* m_state = nullptr;
    QProgressBar* m_progress = nullptr;
    QToolButton* m_stop = nullptr;
    QTimer m_showProgress; ///< work that is done at once shows none
    QTimer m_showState;
    QList<QDockWidget*> m_hiddenDocks;
    QByteArray m_firstLayout;
    double m_drawSeconds = -1.0;
};

} // namespace mirrorball::studio
