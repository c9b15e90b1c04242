#include "kept_picture.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

namespace mirrorball::studio {

QString keepPicture(const QImage& picture, const QString& sceneFile)
{
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QBuffer::WriteOnly);
    if (picture.isNull() || !picture.save(&buffer, "PNG"))
        return {};
    const QString beside =
        sceneFile.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) : QFileInfo(sceneFile).absolutePath();
    const QDir folder(beside + QStringLiteral("/pasted"));
    const QString name = QString::fromLatin1(QCryptographicHash::hash(png, QCryptographicHash::Sha256).toHex().left(12));
    const QString path = folder.filePath(QStringLiteral("picture-%1.png").arg(name));
    if (QFileInfo::exists(path))
        return path;
    folder.mkpath(QStringLiteral("."));
    QSaveFile file(path);
    return file.open(QFile::WriteOnly) && file.write(png) == png.size() && file.commit() ? path : QString();
}

} // namespace mirrorball::studio
