#include "probe_watcher.h"

#include "widgets/controls/text.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>

namespace mirrorball::studio {

ProbeWatcher::ProbeWatcher(Workspace& workspace, QObject* parent) : QObject(parent), m_workspace(workspace)
{
    m_lookSoon.setSingleShot(true);
    m_lookSoon.setInterval(250);
    connect(&m_lookSoon, &QTimer::timeout, this, &ProbeWatcher::look);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_lookSoon, qOverload<>(&QTimer::start));
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_lookSoon, qOverload<>(&QTimer::start));
    connect(&workspace.document, &Document::changed, this, &ProbeWatcher::follow);
    connect(&workspace.document, &Document::fileChanged, this, &ProbeWatcher::follow);
    follow();
}

void ProbeWatcher::follow()
{
    const Scene& scene = m_workspace.document.scene();
    QString source = QString::fromStdString(resolved(scene, scene.probe.source));
    if (!source.startsWith(QStringLiteral("builtin:")))
        source = QDir::cleanPath(QFileInfo(source).absoluteFilePath());
    if (source == m_source)
        return;
    m_source = source;
    m_stamp = stamp();
    watch();
    emit sourceChanged();
}

void ProbeWatcher::watch()
{
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty())
        m_watcher.removePaths(watched);
    if (m_source.startsWith(QStringLiteral("builtin:")))
        return;
    if (QFileInfo::exists(m_source))
        m_watcher.addPath(m_source);
    const QString folder = QFileInfo(m_source).absolutePath();
    if (QFileInfo::exists(folder))
        m_watcher.addPath(folder);
}

/// What tells one state of the file from the next; empty while there is none.
QString ProbeWatcher::stamp() const
{
    const QFileInfo file(m_source);
    return file.exists() ? QStringLiteral("%1 %2").arg(file.lastModified().toMSecsSinceEpoch()).arg(file.size()) : QString();
}

void ProbeWatcher::look()
{
    watch(); // a file that was replaced is watched no longer
    const QString now = stamp();
    if (now == m_stamp)
        return;
    m_stamp = now;
    m_workspace.live.refresh();
    m_workspace.library.refresh(m_source);
    emit fileChanged();
}

} // namespace mirrorball::studio
