#include "file_actions.h"

#include "theme.h"

#include "core/base/error.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>

namespace mirrorball::studio {

namespace {

constexpr int recentCount = 10;
const QString recentKey = QStringLiteral("recentFiles");

} // namespace

FileActions::FileActions(QWidget& window, Workspace& workspace) : QObject(&window), m_window(window), m_workspace(workspace) {}

bool FileActions::isSceneFile(const QString& path) { return path.endsWith(QStringLiteral(".mirrorball"), Qt::CaseInsensitive); }

void FileActions::addTo(QMenu& menu)
{
    const auto add = [&](const char* id, const char* iconName, const QString& text, const QString& help, const QKeySequence& key,
                         auto slot) {
        QAction* action = menu.addAction(icon(iconName), text, this, slot);
        action->setObjectName(QLatin1String(id));
        action->setShortcut(key);
        action->setToolTip(help);
        action->setStatusTip(help);
        return action;
    };
    add("file.new", "new", tr("&New scene"), tr("Start a new scene"), QKeySequence::New, &FileActions::newScene);
    add("file.open", "open", tr("&Open…"), tr("Open a scene file"), QKeySequence::Open, &FileActions::open);
    QMenu* recent = menu.addMenu(tr("Open &recent"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(*recent); });
    fillRecent(*recent);
    menu.addSeparator();
    add("file.save", "save", tr("&Save"), tr("Save the scene"), QKeySequence::Save, &FileActions::save);
    add("file.saveAs", "save", tr("Save &as…"), tr("Save the scene under another name"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
        &FileActions::askAndSave);
}

void FileActions::newScene()
{
    if (mayGoOn())
        m_workspace.document.reset();
}

void FileActions::open()
{
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open scene"), QFileInfo(m_workspace.document.filePath()).path(),
                                                      tr("Mirrorball scenes (*.mirrorball);;All files (*)"));
    if (!path.isEmpty())
        openScene(path);
}

bool FileActions::openScene(const QString& path)
{
    if (!mayGoOn())
        return false;
    try {
        m_workspace.document.load(path);
        m_workspace.notices.clear(QStringLiteral("file"));
        remember(m_workspace.document.filePath());
        return true;
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = QStringLiteral("file"),
                                 .text = QString::fromUtf8(error.what()),
                                 .actionText = tr("Open another…"),
                                 .action = [this] { open(); }});
        return false;
    }
}

bool FileActions::save() { return m_workspace.document.filePath().isEmpty() ? askAndSave() : saveAs(m_workspace.document.filePath()); }

bool FileActions::askAndSave()
{
    const QString now = m_workspace.document.filePath();
    QString path =
        QFileDialog::getSaveFileName(&m_window, tr("Save scene"), now.isEmpty() ? tr("untitled") + QStringLiteral(".mirrorball") : now,
                                     tr("Mirrorball scenes (*.mirrorball)"));
    if (path.isEmpty())
        return false;
    if (QFileInfo(path).suffix().isEmpty())
        path += QStringLiteral(".mirrorball");
    return saveAs(path);
}

bool FileActions::saveAs(const QString& path)
{
    try {
        m_workspace.document.save(path);
        m_workspace.notices.clear(QStringLiteral("save"));
        remember(m_workspace.document.filePath());
        return true;
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = QStringLiteral("save"),
                                 .text = tr("Not saved: %1").arg(QString::fromUtf8(error.what())),
                                 .actionText = tr("Save elsewhere…"),
                                 .action = [this] { askAndSave(); }});
        return false;
    }
}

bool FileActions::mayGoOn()
{
    if (!m_workspace.document.isModified())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("Save the changes to %1?").arg(m_workspace.document.title()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box.setInformativeText(tr("They are lost otherwise."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        return true;
    default:
        return false;
    }
}

QStringList FileActions::recentFiles() const { return QSettings().value(recentKey).toStringList(); }

void FileActions::remember(const QString& path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(recentKey, files.mid(0, recentCount));
}

void FileActions::fillRecent(QMenu& menu)
{
    menu.clear();
    for (const QString& path : recentFiles()) {
        QAction* action = menu.addAction(QFileInfo(path).fileName(), this, [this, path] { openScene(path); });
        action->setToolTip(path);
        action->setStatusTip(path);
    }
    if (menu.isEmpty())
        menu.addAction(tr("No files yet"))->setEnabled(false);
}

} // namespace mirrorball::studio
