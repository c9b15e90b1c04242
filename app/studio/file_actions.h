#pragma once

#include "widgets/files/file_opener.h"
#include "widgets/workspace/workspace.h"

#include <QMenu>
#include <QObject>

namespace mirrorball::studio {

/// Opening files of every kind and saving the document: the guard of unsaved changes, recent files, and what is wrong as a notice.
class FileActions : public QObject {
    Q_OBJECT

public:
    /// @param window parent of the dialogs
    FileActions(QWidget& window, Workspace& workspace);

    FileOpener& opener() { return m_opener; }

    /// New, Open, Recent, Save, Save as.
    void addTo(QMenu& menu);
    /// Opens a scene file, asking about unsaved changes. @return whether it is open now
    bool openScene(const QString& path);
    bool save();
    bool saveAs(const QString& path);
    /// Saves, discards or stops, as the user says. @return whether to go on
    bool mayGoOn();

private:
    void newScene();
    void askAndOpen();
    bool askAndSave();
    void fillRecent(QMenu& menu);
    void fillSamples(QMenu& menu);
    void openSample(const QString& file);

    QWidget& m_window;
    Workspace& m_workspace;
    FileOpener m_opener;
};

} // namespace mirrorball::studio
