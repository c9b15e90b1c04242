#include "recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace mirrorball::studio {

namespace {

constexpr qsizetype mostRecent = 15;
const QString recentKey = QStringLiteral("recent"); ///< "kind path" each

void keep(const QVector<RecentFile>& files)
{
    QStringList lines;
    for (const RecentFile& file : files.mid(0, mostRecent))
        lines << kindWord(file.kind) + u' ' + file.path;
    QSettings().setValue(recentKey, lines);
}

} // namespace

QVector<RecentFile> recentFiles()
{
    QVector<RecentFile> files;
    for (const QString& line : QSettings().value(recentKey).toStringList())
        if (const FileKind kind = kindOfWord(line.section(u' ', 0, 0)); kind != FileKind::Unknown)
            files.push_back({line.section(u' ', 1), kind});
    return files;
}

void rememberRecent(const QString& path, FileKind kind)
{
    const QString absolute = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    QVector<RecentFile> files = recentFiles();
    files.removeIf([&](const RecentFile& file) { return file.path == absolute; });
    files.prepend({absolute, kind});
    keep(files);
}

void forgetRecent(const QString& path)
{
    QVector<RecentFile> files = recentFiles();
    files.removeIf([&](const RecentFile& file) { return file.path == path; });
    keep(files);
}

} // namespace mirrorball::studio
