#pragma once

#include "widgets/files/file_opener.h"
#include "widgets/picture/preview_widget.h"
#include "widgets/workspace/workspace.h"

#include <QAction>
#include <QMenu>
#include <QObject>

namespace mirrorball::studio {

/// Undo, and the clipboard: layers are copied, duplicated and pasted as JSON texts, pictures and files are pasted as if they were dropped
/// where the keys go. Text fields keep these keys for themselves.
class EditActions : public QObject {
    Q_OBJECT

public:
    EditActions(QWidget& window, Workspace& workspace, FileOpener& opener, PreviewWidget& preview);

    void addTo(QMenu& menu);

    /// The chosen layer where the keys go to the sphere map, else the picture.
    void copy();
    void paste();
    /// Keeps a picture without a file as one; a notice tells where that fails. @return its path; empty: it failed
    QString keep(const QImage& picture);

private:
    bool isOnSphereMap() const;
    bool pasteCopiedLayers();
    void refresh();

    QWidget& m_window;
    Workspace& m_workspace;
    FileOpener& m_opener;
    PreviewWidget& m_preview;
    QAction* m_duplicate = nullptr;
};

} // namespace mirrorball::studio
