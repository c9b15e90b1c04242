#pragma once

#include "core/scene/scene.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>

namespace mirrorball::studio {

/// What of a scene an edit touched.
enum class Part : unsigned { Probe = 1, Map = 2, Material = 4, View = 8, Exports = 16, Folder = 32, All = 63 };
Q_DECLARE_FLAGS(Parts, Part)
Q_DECLARE_OPERATORS_FOR_FLAGS(Parts)

/// Which parts of two scenes differ.
Parts differing(const Scene& a, const Scene& b);

/// What the studio begins with: a scene as a file without a field has it, but dithered - files that say nothing of it keep their bytes.
Scene newScene();

/// The one place of state: the scene that is being edited, its file, its undo stack. Widgets read scene(), change it through edit() and
/// redraw on changed(); they never talk to each other.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    const Scene& scene() const { return m_scene; }
    /// Absolute; empty for a scene that has no file yet.
    const QString& filePath() const { return m_filePath; }
    /// The file's name, or what stands for it.
    QString title() const;
    bool isModified() const { return !m_undoStack.isClean(); }
    QUndoStack& undoStack() { return m_undoStack; }

    /// Changes the scene by one undo step. Edits of the same non-empty key merge into one step until finishEdit(): a drag.
    /// An edit that makes the scene invalid is left undone and reported by refused().
    void edit(const QString& label, const QString& mergeKey, const std::function<void(Scene&)>& change);
    /// The same for a change that knows how to take itself back, and is small beside the scene: a stroke on a painted map. The undo step
    /// keeps the two functions and no scene; `undo` gets the scene that `redo` left.
    void editReversibly(const QString& label, std::function<void(Scene&)> redo, std::function<void(Scene&)> undo);
    /// The end of a drag.
    void finishEdit();
    /// Between the first edit with a key and finishEdit(): results may be coarse, the next value is near.
    bool isDragging() const { return !m_mergeKey.isEmpty(); }

    /// A new scene without a file.
    void reset(const Scene& scene = newScene());
    /// @throws FileError; the document then is as it was
    void load(const QString& path);
    /// Writes the scene and makes `path` the document's file. Paths below its folder become relative to it. @throws InvalidArgument,
    /// WorkError
    void save(const QString& path);
    /// A scene found after a crash: not saved yet. @param path  the file it belongs to; empty: none
    void recover(const Scene& scene, const QString& path);

signals:
    void changed(mirrorball::studio::Parts parts);
    void dragFinished();
    void fileChanged();
    void modifiedChanged(bool modified);
    /// An edit was not done, and why.
    void refused(const QString& message);

private:
    void apply(const Scene& scene);
    void replace(const Scene& scene, const QString& path);

    Scene m_scene = newScene();
    QString m_filePath;
    QUndoStack m_undoStack;
    QString m_mergeKey;
    unsigned m_dragNumber = 0; ///< tells one drag of a control from the next
};

} // namespace mirrorball::studio
