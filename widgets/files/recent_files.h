#pragma once

#include "file_kind.h"

#include <QVector>

namespace mirrorball::studio {

/// A file that was opened or saved, of any kind.
struct RecentFile {
    QString path; ///< absolute
    FileKind kind = FileKind::Unknown;
    bool operator==(const RecentFile&) const = default;
};

/// The files that were opened or saved last, of all kinds in one list, the newest first; kept between runs.
QVector<RecentFile> recentFiles();
/// Puts a file at the head of the list; once.
void rememberRecent(const QString& path, FileKind kind);
/// Takes it off: it is gone.
void forgetRecent(const QString& path);

} // namespace mirrorball::studio
