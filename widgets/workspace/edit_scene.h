#pragma once

#include "core/scene/scene.h"

#include <QUndoCommand>

#include <functional>

namespace mirrorball::studio {

/// The one undo command for settings: the scene before and after. Undo and redo both hand a scene to `apply`. Commands of the same
/// non-empty key merge into one, and one that changed nothing in the end removes itself.
class EditScene : public QUndoCommand {
public:
    using Apply = std::function<void(const Scene&)>;

    EditScene(const QString& label, QString mergeKey, Scene before, Scene after, Apply apply);

    void undo() override { m_apply(m_before); }
    void redo() override { m_apply(m_after); }
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand* next) override;

private:
    QString m_mergeKey;
    Scene m_before;
    Scene m_after;
    Apply m_apply;
};

/// An edit that knows how to take itself back: it keeps no scene.
class ReversibleEdit : public QUndoCommand {
public:
    ReversibleEdit(const QString& label, std::function<void()> redo, std::function<void()> undo)
        : QUndoCommand(label), m_redo(std::move(redo)), m_undo(std::move(undo))
    {
    }
    void undo() override { m_undo(); }
    void redo() override { m_redo(); }

private:
    std::function<void()> m_redo;
    std::function<void()> m_undo;
};

} // namespace mirrorball::studio
