#include "file_dialogs.h"

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QIcon>
#include <QSettings>
#include <QStandardPaths>

#include <utility>

namespace mirrorball::studio {

namespace {

QString keyOf(const QString& purpose) { return QStringLiteral("folders/") + purpose; }
const QString lastPurpose = QStringLiteral("last");

void remember(const QString& purpose, const QString& folder)
{
    QSettings settings;
    settings.setValue(keyOf(purpose), folder);
    settings.setValue(keyOf(lastPurpose), folder);
}

/// Where a dialog begins: a file that is there comes before what is remembered.
QString beginning(const FileQuestion& question)
{
    const QFileInfo start(question.start);
    if (!question.start.isEmpty() && start.isAbsolute() && start.dir().exists())
        return question.start;
    const QString folder = rememberedFolder(question.purpose);
    return question.start.isEmpty() ? folder : QDir(folder).filePath(start.fileName());
}

/// Ends of the dialogs: what was chosen says which folder comes next.
QString ended(const QString& purpose, const QString& path)
{
    if (!path.isEmpty())
        remember(purpose, QFileInfo(path).absolutePath());
    return path;
}

} // namespace

QString rememberedFolder(const QString& purpose)
{
    const QSettings settings;
    for (const QString& each : {purpose, lastPurpose})
        if (const QString folder = settings.value(keyOf(each)).toString(); !folder.isEmpty() && QDir(folder).exists())
            return folder;
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

QString askForFile(QWidget* parent, const FileQuestion& question)
{
    return ended(question.purpose, QFileDialog::getOpenFileName(parent, question.title, beginning(question), question.filter));
}

void addFileButton(QLineEdit& text, const FileQuestion& question, std::function<void(const QString& path)> chosen)
{
    QAction* button = text.addAction(QIcon(QStringLiteral(":/icons/open.svg")), QLineEdit::TrailingPosition);
    button->setObjectName(QStringLiteral("chooseFile"));
    button->setToolTip(QCoreApplication::translate("FileDialogs", "Choose a file"));
    QObject::connect(button, &QAction::triggered, &text, [&text, question, chosen = std::move(chosen)] {
        FileQuestion now = question;
        now.start = text.text();
        if (const QString path = askForFile(&text, now); !path.isEmpty())
            chosen(path);
    });
}

QStringList askForFiles(QWidget* parent, const FileQuestion& question)
{
    const QStringList files = QFileDialog::getOpenFileNames(parent, question.title, beginning(question), question.filter);
    if (!files.isEmpty())
        ended(question.purpose, files.front());
    return files;
}

QString askForFolder(QWidget* parent, const FileQuestion& question)
{
    const QString folder = QFileDialog::getExistingDirectory(parent, question.title, beginning(question));
    if (!folder.isEmpty())
        remember(question.purpose, QDir(folder).absolutePath());
    return folder;
}

SaveAnswer askWhereToSave(QWidget* parent, const FileQuestion& question, const QString& ending)
{
    SaveAnswer answer;
    answer.path = QFileDialog::getSaveFileName(parent, question.title, beginning(question), question.filter, &answer.filter);
    if (!answer.path.isEmpty() && QFileInfo(answer.path).suffix().isEmpty())
        answer.path += ending;
    ended(question.purpose, answer.path);
    return answer;
}

} // namespace mirrorball::studio
