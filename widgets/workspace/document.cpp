#include "document.h"

#include "edit_scene.h"
#include "widgets/controls/text.h"

#include "core/base/error.h"
#include "core/scene/scene_file.h"

#include <QFileInfo>

namespace mirrorball::studio {

Parts differing(const Scene& a, const Scene& b)
{
    Parts parts;
    parts.setFlag(Part::Probe, a.probe != b.probe);
    parts.setFlag(Part::Map, a.map != b.map);
    parts.setFlag(Part::Material, a.material != b.material || a.filter != b.filter);
    parts.setFlag(Part::View, a.view != b.view);
    parts.setFlag(Part::Exports, a.exports != b.exports);
    parts.setFlag(Part::Folder, a.folder != b.folder);
    return parts;
}

Scene newScene()
{
    Scene scene;
    scene.view.dither = true;
    return scene;
}

Document::Document(QObject* parent) : QObject(parent)
{
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, [this](bool clean) { emit modifiedChanged(!clean); });
}

QString Document::title() const { return m_filePath.isEmpty() ? tr("Untitled") : QFileInfo(m_filePath).fileName(); }

void Document::edit(const QString& label, const QString& mergeKey, const std::function<void(Scene&)>& change)
{
    Scene after = m_scene;
    change(after);
    if (after == m_scene)
        return;
    try {
        validate(after);
    } catch (const InvalidArgument& error) {
        emit refused(QString::fromUtf8(error.what()));
        return;
    }
    if (mergeKey != m_mergeKey) {
        finishEdit();
        m_mergeKey = mergeKey;
    }
    const QString key = mergeKey.isEmpty() ? QString() : mergeKey + u'#' + QString::number(m_dragNumber);
    m_undoStack.push(new EditScene(label, key, m_scene, after, [this](const Scene& scene) { apply(scene); }));
}

void Document::editReversibly(const QString& label, std::function<void(Scene&)> redo, std::function<void(Scene&)> undo)
{
    Scene after = m_scene;
    redo(after);
    try {
        validate(after);
    } catch (const InvalidArgument& error) {
        emit refused(QString::fromUtf8(error.what()));
        return;
    }
    finishEdit();
    const auto change = [this](const std::function<void(Scene&)>& step) {
        Scene changed = m_scene;
        step(changed);
        apply(changed);
    };
    m_undoStack.push(new ReversibleEdit(
        label, [change, redo = std::move(redo)] { change(redo); }, [change, undo = std::move(undo)] { change(undo); }));
}

void Document::finishEdit()
{
    if (m_mergeKey.isEmpty())
        return;
    m_mergeKey.clear();
    ++m_dragNumber;
    emit dragFinished();
}

void Document::apply(const Scene& scene)
{
    const Parts parts = differing(m_scene, scene);
    if (!parts)
        return;
    m_scene = scene;
    emit changed(parts);
}

void Document::replace(const Scene& scene, const QString& path)
{
    finishEdit();
    const bool sameFile = m_filePath == path;
    m_filePath = path;
    m_scene = scene;
    m_undoStack.clear();
    if (!sameFile || path.isEmpty())
        emit fileChanged();
    emit changed(Part::All);
}

void Document::reset(const Scene& scene) { replace(scene, {}); }

void Document::load(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    replace(loadScene(toPath(absolute)), absolute);
}

void Document::save(const QString& path)
{
    finishEdit();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    saveScene(m_scene, toPath(absolute));
    apply(loadScene(toPath(absolute))); // what a reader of the file gets: paths start at its folder from now on
    m_undoStack.setClean();
    if (m_filePath != absolute) {
        m_filePath = absolute;
        emit fileChanged();
    }
}

void Document::recover(const Scene& scene, const QString& path)
{
    replace(scene, path);
    m_undoStack.resetClean();
    emit modifiedChanged(true);
}

} // namespace mirrorball::studio
