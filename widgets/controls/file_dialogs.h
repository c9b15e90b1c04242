#pragma once

#include <QLineEdit>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <functional>

/// File dialogs that remember: each purpose begins in the folder where it last ended, in the next run too.
namespace mirrorball::studio {

struct FileQuestion {
    QString purpose;  ///< whose folder it is: "open", "export"; names it in the settings, so it never changes
    QString title;    ///< of the dialog
    QString filter{}; ///< as QFileDialog has it; empty: all files
    /// A file that is there already, whose folder then comes first; or the name that a new file might have. Empty: none.
    QString start{};
};

/// A file to read; empty: the user thought better of it.
QString askForFile(QWidget* parent, const FileQuestion& question);
/// A button inside of a text that names a file: asks for one, beginning at the one that is named, and hands its path over.
void addFileButton(QLineEdit& text, const FileQuestion& question, std::function<void(const QString& path)> chosen);
/// One or more of them; empty: none.
QStringList askForFiles(QWidget* parent, const FileQuestion& question);
/// A folder; empty: none. Its own content is what the next question begins with.
QString askForFolder(QWidget* parent, const FileQuestion& question);

struct SaveAnswer {
    QString path{};   ///< empty: none
    QString filter{}; ///< the line of the filter that was chosen
};
/// Where to write. A name that is given no ending gets `ending` (".png").
SaveAnswer askWhereToSave(QWidget* parent, const FileQuestion& question, const QString& ending = {});

/// The folder that a purpose begins in: its own, else that of the last dialog of any purpose, else the user's documents.
QString rememberedFolder(const QString& purpose);

} // namespace mirrorball::studio
