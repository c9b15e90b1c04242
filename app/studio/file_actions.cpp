#include "file_actions.h"

#include "menu_action.h"
#include "samples.h"
#include "theme.h"

#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/text.h"
#include "widgets/files/recent_files.h"
#include "widgets/files/use_file.h"

#include "core/base/error.h"
#include "core/scene/scene_file.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>

namespace mirrorball::studio {

FileActions::FileActions(QWidget& window, Workspace& workspace)
    : QObject(&window), m_window(window), m_workspace(workspace), m_opener(workspace)
{
    m_opener.setSceneOpener([this](const QString& path) { return openScene(path); });
}

void FileActions::addTo(QMenu& menu)
{
    const auto add = [&](const char* id, const char* iconName, const QString& text, const QString& help, const QKeySequence& key,
                         auto slot) { return addCommand(menu, id, icon(iconName), text, help, key, this, slot); };
    add("file.new", "new", tr("&New scene"), tr("Start a new scene"), QKeySequence::New, &FileActions::newScene);
    add("file.open", "open", tr("&Open…"), tr("Open a scene, a light probe or another picture, a mesh, a sphere map or a material"),
        QKeySequence::Open, &FileActions::askAndOpen);
    QMenu* recent = menu.addMenu(tr("Open &recent"));
    recent->setObjectName(QStringLiteral("file.recent"));
    recent->setToolTipsVisible(true);
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(*recent); });
    fillRecent(*recent);
    QMenu* sampleMenu = menu.addMenu(tr("Open a sa&mple"));
    sampleMenu->setObjectName(QStringLiteral("file.samples"));
    sampleMenu->setToolTipsVisible(true);
    fillSamples(*sampleMenu);
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

void FileActions::askAndOpen()
{
    m_opener.open(askForFiles(&m_window, {.purpose = QStringLiteral("open"), .title = tr("Open"), .filter = openFilter()}));
}

bool FileActions::openScene(const QString& path)
{
    if (!mayGoOn())
        return false;
    try {
        m_workspace.document.load(path);
        m_workspace.notices.clear(QStringLiteral("file"));
        rememberRecent(m_workspace.document.filePath(), FileKind::Scene);
        return true;
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = QStringLiteral("file"),
                                 .text = QString::fromUtf8(error.what()),
                                 .actionText = tr("Open another…"),
                                 .action = [this] { askAndOpen(); }});
        return false;
    }
}

bool FileActions::save() { return m_workspace.document.filePath().isEmpty() ? askAndSave() : saveAs(m_workspace.document.filePath()); }

bool FileActions::askAndSave()
{
    const QString now = m_workspace.document.filePath();
    const QString ending = QStringLiteral(".mirrorball");
    const QString path = askWhereToSave(&m_window,
                                        {.purpose = QStringLiteral("save"),
                                         .title = tr("Save scene"),
                                         .filter = tr("Mirrorball scenes (*.mirrorball)"),
                                         .start = now.isEmpty() ? tr("untitled") + ending : now},
                                        ending)
                             .path;
    return !path.isEmpty() && saveAs(path);
}

bool FileActions::saveAs(const QString& path)
{
    try {
        m_workspace.document.save(path);
        m_workspace.notices.clear(QStringLiteral("save"));
        rememberRecent(m_workspace.document.filePath(), FileKind::Scene);
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

void FileActions::fillSamples(QMenu& menu)
{
    for (const Sample& sample : samples()) {
        const bool isScene = sample.file.endsWith(QStringLiteral(".mirrorball"));
        QAction* action = menu.addAction(tr("%1  (%2)").arg(sample.title, kindText(isScene ? FileKind::Scene : FileKind::SphereMap)), this,
                                         [this, file = sample.file] { openSample(file); });
        action->setToolTip(isScene ? tr("A scene to begin from; it has no file until it is saved")
                                   : tr("A sphere map to begin from: it becomes the scene's own"));
    }
}

// A sample belongs to no file of the user's: saving asks where.
void FileActions::openSample(const QString& file)
{
    const QString path = samplePath(file);
    if (fileKind(path) != FileKind::Scene) {
        useSphereMap(m_workspace, path);
        return;
    }
    if (!mayGoOn())
        return;
    try {
        m_workspace.document.reset(loadScene(toPath(path)));
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = QStringLiteral("file"), .text = QString::fromUtf8(error.what())});
    }
}

void FileActions::fillRecent(QMenu& menu)
{
    menu.clear();
    for (const RecentFile& file : recentFiles()) {
        QAction* action = menu.addAction(tr("%1  (%2)").arg(QFileInfo(file.path).fileName(), kindText(file.kind)), this,
                                         [this, path = file.path] { m_opener.open({path}); });
        if (file.kind == FileKind::Mesh) {
            action->setIcon(m_workspace.meshes.icon(file.path));
            connect(&m_workspace.meshes, &MeshThumbnails::made, action, [this, action, path = file.path](const QString& geometry) {
                if (geometry == path)
                    action->setIcon(m_workspace.meshes.icon(path));
            });
        }
        action->setToolTip(QDir::toNativeSeparators(file.path));
        action->setStatusTip(QDir::toNativeSeparators(file.path));
    }
    if (menu.isEmpty())
        menu.addAction(tr("No files yet"))->setEnabled(false);
}

} // namespace mirrorball::studio
