#pragma once

#include "widgets/drop_target.h"
#include "widgets/preview_widget.h"
#include "widgets/workspace.h"

#include <QDockWidget>
#include <QMainWindow>

namespace mirrorball::studio {

/// The window of one document: the preview in the middle, docks around it.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    Workspace& workspace() { return m_workspace; }
    PreviewWidget& preview() { return *m_preview; }
    DropTarget& dropTarget() { return *m_dropTarget; }
    /// The dock of that id (docks.h), or null.
    QDockWidget* dock(const QString& id) const;

private:
    void addDocks();
    void addActions();
    void showTitle();

    Workspace m_workspace; ///< outlives the widgets, which are children
    PreviewWidget* m_preview;
    DropTarget* m_dropTarget;
};

} // namespace mirrorball::studio
