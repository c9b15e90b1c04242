#include "edit_actions.h"

#include "menu_action.h"
#include "theme.h"

#include "widgets/files/kept_picture.h"
#include "widgets/spheremap/layer_clipboard.h"
#include "widgets/spheremap/sphere_map_panel.h"

#include "core/base/error.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <QUrl>

namespace mirrorball::studio {

EditActions::EditActions(QWidget& window, Workspace& workspace, FileOpener& opener, PreviewWidget& preview)
    : QObject(&window), m_window(window), m_workspace(workspace), m_opener(opener), m_preview(preview)
{
}

void EditActions::addTo(QMenu& menu)
{
    QAction* undo = m_workspace.document.undoStack().createUndoAction(this, tr("Undo"));
    undo->setObjectName(QStringLiteral("edit.undo"));
    undo->setIcon(icon("undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = m_workspace.document.undoStack().createRedoAction(this, tr("Redo"));
    redo->setObjectName(QStringLiteral("edit.redo"));
    redo->setIcon(icon("redo"));
    redo->setShortcuts({QKeySequence::Redo, QKeySequence(Qt::CTRL | Qt::Key_Y)});
    menu.addActions({undo, redo});
    menu.addSeparator();
    const auto add = [&](const char* id, const char* iconName, const QString& text, const QString& help, const QKeySequence& key,
                         auto slot) { return addCommand(menu, id, icon(iconName), text, help, key, this, slot); };
    add("edit.copy", "duplicate", tr("&Copy"), tr("Copy the chosen layer while the sphere map has the keys, else the picture"),
        QKeySequence::Copy, &EditActions::copy);
    add("edit.paste", "add", tr("&Paste"), tr("Paste layers, a picture or files: what a drop at the place of the keys would do"),
        QKeySequence::Paste, &EditActions::paste);
    m_duplicate = add("edit.duplicate", "duplicate", tr("&Duplicate layer"), tr("Copy the chosen layer of the sphere map"),
                      QKeySequence(Qt::CTRL | Qt::Key_D), [this] { m_workspace.sphereMap.duplicateChosen(); });
    connect(&m_workspace.sphereMap, &SphereMapEditor::mapChanged, this, &EditActions::refresh);
    connect(&m_workspace.sphereMap, &SphereMapEditor::chosenChanged, this, &EditActions::refresh);
    refresh();
}

void EditActions::refresh() { m_duplicate->setEnabled(m_workspace.sphereMap.chosenLayer() != nullptr); }

bool EditActions::isOnSphereMap() const
{
    for (const QWidget* at = QApplication::focusWidget(); at; at = at->parentWidget())
        if (qobject_cast<const SphereMapPanel*>(at))
            return true;
    return false;
}

void EditActions::copy()
{
    if (isOnSphereMap() && m_workspace.sphereMap.chosenLayer())
        copyLayer(m_workspace.sphereMap);
    else if (!m_preview.picture().isNull())
        QApplication::clipboard()->setImage(m_preview.picture());
}

void EditActions::paste()
{
    const QMimeData* data = QApplication::clipboard()->mimeData();
    if (!data || pasteCopiedLayers())
        return;
    QStringList paths;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile())
            paths << url.toLocalFile();
    if (paths.isEmpty() && data->hasImage())
        paths << keep(data->imageData().value<QImage>());
    paths.removeAll(QString());
    if (!paths.isEmpty())
        m_opener.open(paths, isOnSphereMap() && m_workspace.sphereMap.map() ? DropPlace::Layers
                             : isOnSphereMap()                              ? DropPlace::SphereMap
                                                                            : DropPlace::Elsewhere);
}

/// @return whether there were layers to paste
bool EditActions::pasteCopiedLayers()
{
    if (!hasCopiedLayers())
        return false;
    try {
        pasteLayers(m_workspace.sphereMap);
    } catch (const Error& error) {
        m_workspace.notices.set(
            {.subject = QStringLiteral("paste"), .text = tr("Nothing was pasted: %1").arg(QString::fromUtf8(error.what()))});
    }
    return true;
}

QString EditActions::keep(const QImage& picture)
{
    const QString path = keepPicture(picture, m_workspace.document.filePath());
    m_workspace.notices.set({.subject = QStringLiteral("paste"),
                             .text = path.isEmpty()
                                         ? tr("The picture cannot be kept: its folder cannot be written; save the scene in another one")
                                         : QString()});
    return path;
}

} // namespace mirrorball::studio
