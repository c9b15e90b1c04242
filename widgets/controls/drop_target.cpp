#include "drop_target.h"

#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

namespace mirrorball::studio {

namespace {

QStringList localPaths(const QMimeData* dropped)
{
    QStringList paths;
    if (dropped && dropped->hasUrls())
        for (const QUrl& url : dropped->urls())
            if (url.isLocalFile())
                paths << url.toLocalFile();
    return paths;
}

} // namespace

DropTarget::DropTarget(QWidget& window, Workspace& workspace) : QObject(&window), m_workspace(workspace)
{
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool DropTarget::eventFilter(QObject*, QEvent* event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::DragMove && event->type() != QEvent::Drop)
        return false;
    auto* drop = static_cast<QDropEvent*>(event);
    const QStringList paths = localPaths(drop->mimeData());
    if (paths.isEmpty())
        return false;
    drop->setDropAction(Qt::CopyAction); // the file stays where it is
    drop->accept();
    if (event->type() == QEvent::Drop)
        open(paths);
    return true;
}

void DropTarget::open(const QStringList& paths)
{
    QStringList refused;
    for (const QString& path : paths)
        if (!openOne(path))
            refused << QFileInfo(path).fileName();
    m_workspace.notices.set({.subject = QStringLiteral("drop"),
                             .text = refused.isEmpty() ? QString()
                                                       : tr("%1: is neither an image nor a folder nor anything else that can be opened; "
                                                            "drop .hdr, .exr or another image, or a folder of them")
                                                             .arg(refused.join(QStringLiteral(", ")))});
}

bool DropTarget::openOne(const QString& path)
{
    for (const Opener& opener : m_openers)
        if (opener(path))
            return true;
    const QFileInfo file(path);
    if (file.isDir()) {
        m_workspace.library.addFolder(path);
        return true;
    }
    if (!file.exists() || !isProbeFile(path))
        return false;
    const QString source = QDir::cleanPath(file.absoluteFilePath());
    m_workspace.library.addFile(source);
    m_workspace.document.edit(tr("Probe"), {}, [&](Scene& scene) {
        scene.probe.source = source.toStdString();
        scene.probe.reading = {};
    });
    return true;
}

} // namespace mirrorball::studio
