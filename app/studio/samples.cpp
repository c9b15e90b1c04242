#include "samples.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>

namespace mirrorball::studio {

namespace {

const QString inside = QStringLiteral(":/samples");
const QString sceneEnding = QStringLiteral(".mirrorball");

/// "toon-teapot.mirrorball" gives "Toon teapot".
QString titleOf(const QString& file)
{
    QString title = file.section(u'.', 0, 0).replace(u'-', u' ');
    title[0] = title[0].toUpper();
    return title;
}

QByteArray read(const QString& path)
{
    QFile file(path);
    return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

QVector<Sample> samples()
{
    QVector<Sample> all;
    for (const QString& file : QDir(inside).entryList(QDir::Files, QDir::Name))
        all.push_back({file, titleOf(file)});
    std::stable_partition(all.begin(), all.end(), [](const Sample& sample) { return sample.file.endsWith(sceneEnding); });
    return all;
}

QString samplePath(const QString& file)
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/samples"));
    folder.mkpath(QStringLiteral("."));
    for (const Sample& sample : samples()) {
        const QByteArray text = read(inside + u'/' + sample.file);
        const QString path = folder.filePath(sample.file);
        if (read(path) == text)
            continue;
        QSaveFile out(path);
        if (!out.open(QFile::WriteOnly) || out.write(text) != text.size() || !out.commit())
            return {};
    }
    return folder.filePath(file);
}

} // namespace mirrorball::studio
