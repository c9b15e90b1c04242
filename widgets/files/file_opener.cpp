#include "file_opener.h"

#include "recent_files.h"
#include "use_file.h"

#include <QFileInfo>

namespace mirrorball::studio {

namespace {

const QString noticeSubject = QStringLiteral("open");

/// Whether nothing is there. The six faces of a cube go by one name with a mark.
bool isMissing(const QString& path) { return !path.contains(QStringLiteral("%s")) && !QFileInfo::exists(path); }

} // namespace

FileOpener::FileOpener(Workspace& workspace, QObject* parent) : QObject(parent), m_workspace(workspace) {}

void FileOpener::open(const QStringList& paths, DropPlace place)
{
    QStringList missing, strange;
    for (const QString& path : paths) {
        const QString name = QFileInfo(path).fileName();
        if (isMissing(path)) {
            missing << path;
            forgetRecent(path);
        } else if (!openOne(path, place)) {
            strange << (name.isEmpty() ? path : name);
        }
    }
    QStringList problems;
    if (!missing.isEmpty())
        problems << tr("%1: there is no such file; it may have been moved or renamed").arg(missing.join(QStringLiteral(", ")));
    if (!strange.isEmpty())
        problems
            << tr("%1: is nothing that can be opened here; choose a scene, a light probe or another picture, a folder of them, a mesh, "
                  "a sphere map or a material")
                   .arg(strange.join(QStringLiteral(", ")));
    m_workspace.notices.set({.subject = noticeSubject, .text = problems.join(u'\n')});
}

/// @return false where it is of no kind that can be opened; what is wrong inside a file is told by its own notice
bool FileOpener::openOne(const QString& path, DropPlace place)
{
    const FileKind kind = fileKind(path);
    bool isOpen = true;
    switch (kind) {
    case FileKind::Scene:
        if (!m_openScene)
            return false;
        isOpen = m_openScene(path);
        break;
    case FileKind::Material:
        isOpen = useMaterial(m_workspace, path);
        break;
    case FileKind::SphereMap:
        isOpen = useSphereMap(m_workspace, path);
        break;
    case FileKind::Mesh:
        useMesh(m_workspace, path);
        break;
    case FileKind::Picture:
        openPicture(path, place);
        return true; // what it became, and when, is told there
    case FileKind::Display:
        useDisplay(m_workspace, path);
        break;
    case FileKind::Folder:
        m_workspace.library.addFolder(path);
        break;
    case FileKind::Unknown:
        return false;
    }
    if (isOpen)
        emit opened(path, kind);
    return true;
}

void FileOpener::openPicture(const QString& path, DropPlace place)
{
    const std::optional<PictureUse> use = useOfPicture(factsOf(path), place);
    if (!use && m_ask)
        m_ask(path);
    else
        usePicture(path, use.value_or(PictureUse::Probe));
}

PictureFacts FileOpener::factsOf(const QString& path)
{
    const QDateTime modified = QFileInfo(path).lastModified();
    if (!m_known || m_known->path != path || m_known->modified != modified)
        m_known = {path, modified, pictureFacts(path).value_or(PictureFacts{})};
    return m_known->facts;
}

void FileOpener::usePicture(const QString& path, PictureUse use, const ProbeReading& reading)
{
    switch (use) {
    case PictureUse::Probe:
        useProbe(m_workspace, path, reading);
        break;
    case PictureUse::SphereMap:
        linkSphereMap(m_workspace, path);
        break;
    case PictureUse::Layer:
        addImageLayer(m_workspace, path);
        break;
    }
    emit opened(path, use == PictureUse::Probe ? FileKind::Picture : FileKind::SphereMap);
}

QString FileOpener::foretell(const QStringList& paths, DropPlace place)
{
    if (paths.size() != 1)
        return tr("Opens %1 files").arg(paths.size());
    const QString &path = paths.front(), name = QFileInfo(path).fileName();
    const FileKind kind = fileKind(path);
    switch (kind) {
    case FileKind::Picture: {
        const std::optional<PictureUse> use = useOfPicture(factsOf(path), place);
        if (!use)
            return tr("Asks what %1 is: light or the picture of a ball").arg(name);
        return (*use == PictureUse::Probe       ? tr("Light probe: %1")
                : *use == PictureUse::SphereMap ? tr("Sphere map of the material: %1")
                                                : tr("Image layer: %1"))
            .arg(name);
    }
    case FileKind::Folder:
        return tr("Folder of light probes: %1").arg(name);
    case FileKind::Unknown:
        return tr("%1 cannot be opened").arg(name);
    default:
        return tr("Opens the %1 %2").arg(kindText(kind), name);
    }
}

} // namespace mirrorball::studio
