#include "edit_scene.h"

#include <utility>

namespace mirrorball::studio {

EditScene::EditScene(const QString& label, QString mergeKey, Scene before, Scene after, Apply apply)
    : QUndoCommand(label), m_mergeKey(std::move(mergeKey)), m_before(std::move(before)), m_after(std::move(after)),
      m_apply(std::move(apply))
{
}

bool EditScene::mergeWith(const QUndoCommand* next)
{
    const auto* edit = static_cast<const EditScene*>(next); // of the same id
    if (m_mergeKey.isEmpty() || edit->m_mergeKey != m_mergeKey)
        return false;
    m_after = edit->m_after;
    setText(edit->text());
    setObsolete(m_after == m_before);
    return true;
}

} // namespace mirrorball::studio
