#include "use_file.h"

#include "picture_use.h"
#include "recent_files.h"

#include "widgets/controls/text.h"
#include "widgets/panels/view_panel.h"

#include "core/base/error.h"
#include "core/scene/scene_file.h"
#include "core/scene/sphere_map_source.h"
#include "core/spheremap/document/sphere_map_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace mirrorball::studio {

namespace {

QString words(const char* text) { return QCoreApplication::translate("UseFile", text); }

QString absolute(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

/// Reads a file and uses it; what is wrong with it becomes the notice of that subject.
template <typename Use>
bool orNotice(Workspace& workspace, const QString& subject, Use use)
{
    try {
        use();
        workspace.notices.clear(subject);
        return true;
    } catch (const Error& error) {
        workspace.notices.set({.subject = subject, .text = QString::fromUtf8(error.what())});
        return false;
    }
}

} // namespace

void useProbe(Workspace& workspace, const QString& path, const ProbeReading& reading)
{
    const QString source = absolute(path);
    workspace.library.addFile(source);
    workspace.document.edit(words(QT_TRANSLATE_NOOP("UseFile", "Probe")), {}, [&](Scene& scene) {
        scene.probe.source = source.toStdString();
        scene.probe.reading = reading;
    });
    rememberRecent(source, FileKind::Picture);
}

void useMesh(Workspace& workspace, const QString& path)
{
    const QString mesh = absolute(path);
    workspace.document.edit(words(QT_TRANSLATE_NOOP("UseFile", "Open mesh")), {},
                            [&](Scene& scene) { useGeometry(scene, mesh.toStdString()); });
    rememberRecent(mesh, FileKind::Mesh);
}

bool useMaterial(Workspace& workspace, const QString& path)
{
    return orNotice(workspace, QStringLiteral("material"), [&] {
        const Material material = loadMaterial(toPath(path));
        workspace.document.edit(words(QT_TRANSLATE_NOOP("UseFile", "Open material")), {}, [&](Scene& scene) { scene.material = material; });
        rememberRecent(path, FileKind::Material);
    });
}

bool useSphereMap(Workspace& workspace, const QString& path)
{
    return orNotice(workspace, QStringLiteral("sphere-map"), [&] {
        workspace.sphereMap.setMap(words(QT_TRANSLATE_NOOP("UseFile", "Open a sphere map")), loadSphereMap(toPath(path)));
        rememberRecent(path, FileKind::SphereMap);
    });
}

void linkSphereMap(Workspace& workspace, const QString& path)
{
    const std::optional<PictureFacts> facts = isSphereMapPicture(path.toStdString()) ? pictureFacts(path) : std::nullopt;
    workspace.document.edit(words(QT_TRANSLATE_NOOP("UseFile", "Link a sphere map")), {}, [&](Scene& scene) {
        if (facts)
            scene.material.sphereMap.fit = facts->isSquare ? Fit::None : Fit::Crop;
        scene.material.sphereMap.document = {};
        scene.material.sphereMap.source = path.toStdString();
    });
    if (isSphereMapFile(path.toStdString())) // and no preset
        rememberRecent(path, fileKind(path));
}

void addImageLayer(Workspace& workspace, const QString& path)
{
    const QString source = absolute(path);
    const std::optional<PictureFacts> facts = pictureFacts(source);
    const ImageLayer image{.source = source.toStdString(), .fit = facts && !facts->isSquare ? Fit::Crop : Fit::None};
    const Layer layer{.name = QFileInfo(source).completeBaseName().toStdString(), .content = image};
    if (workspace.sphereMap.map()) {
        workspace.sphereMap.addLayer(layer);
    } else {
        SphereMapDocument map;
        map.title = layer.name;
        map.layers = {layer};
        workspace.sphereMap.setMap(words(QT_TRANSLATE_NOOP("UseFile", "Add layer")), map);
    }
    rememberRecent(source, FileKind::Picture);
}

void useDisplay(Workspace& workspace, const QString& path)
{
    workspace.document.edit(words(QT_TRANSLATE_NOOP("UseFile", "Change display")), {}, [&](Scene& scene) {
        const UnknownKeys unknown = scene.view.display.unknown;
        scene.view.display = {.config = absolute(path).toStdString(), .unknown = unknown};
    });
    rememberRecent(path, FileKind::Display);
}

} // namespace mirrorball::studio
