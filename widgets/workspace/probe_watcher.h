#pragma once

#include "workspace.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace mirrorball::studio {

/// Watches the file of the document's probe: when it changes on disk, everything is made anew of it. Editors that write a new file and
/// rename it into place are seen too, and a file that was missing and appears.
class ProbeWatcher : public QObject {
    Q_OBJECT

public:
    explicit ProbeWatcher(Workspace& workspace, QObject* parent = nullptr);

    /// The probe as it can be opened: an absolute path, or "builtin:NAME".
    const QString& source() const { return m_source; }

signals:
    /// The scene has another probe now.
    void sourceChanged();
    /// The probe's file changed on disk.
    void fileChanged();

private:
    void follow();
    void watch();
    void look();
    QString stamp() const;

    Workspace& m_workspace;
    QFileSystemWatcher m_watcher;
    QTimer m_lookSoon; ///< a file that is being written changes many times
    QString m_source, m_stamp;
};

} // namespace mirrorball::studio
