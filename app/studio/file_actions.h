#pragma once

#include "widgets/workspace/workspace.h"

#include <QMenu>
#include <QObject>
#include <QStringList>

namespace mirrorball::studio {

/// Opening and saving the document: the guard of unsaved changes, recent files, and what is wrong with a file as a notice.
class FileActions : public QObject {
    Q_OBJECT

public:
    /// @param window parent of the dialogs
    FileActions(QWidget& window, Workspace& workspace);

    /// New, Open, Recent, Save, Save as.
    void addTo(QMenu& menu);
    /// Opens a scene file, asking about unsaved changes. @return whether it is open now
    bool openScene(const QString& path);
    bool save();
    bool saveAs(const QString& path);
    /// Saves, discards or stops, as the user says. @return whether to go on
    bool mayGoOn();
    QStringList recentFiles() const;

    static bool isSceneFile(const QString& path);

private:
    void newScene();
    void open();
    bool askAndSave();
    void remember(const QString& path);
    void fillRecent(QMenu& menu);

    QWidget& m_window;
    Workspace& m_workspace;
};

} // namespace mirrorball::studio
