#include "recovery.h"

#include "widgets/controls/text.h"

#include "core/base/error.h"
#include "core/scene/scene_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSettings>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace mirrorball::studio {

namespace {

const QString secondsKey = QStringLiteral("recovery/seconds");
constexpr const char* originalKey = "studio_recovers"; ///< in the copy: the document's own file

/// A text as JSON, and back.
std::string quoted(const QString& text)
{
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return list.mid(1, list.size() - 2).toStdString();
}

QString unquoted(const std::string& json)
{
    return QJsonDocument::fromJson('[' + QByteArray::fromStdString(json) + ']').array().at(0).toString();
}

QString lockOf(const QString& copy) { return copy + QStringLiteral(".lock"); }

QString takeOriginal(Scene& scene)
{
    const auto entry = scene.unknown.find(originalKey);
    if (entry == scene.unknown.end())
        return {};
    const QString original = unquoted(entry->second);
    scene.unknown.erase(entry);
    return original;
}

} // namespace

QString Recovery::defaultFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/recovery");
}

Recovery::Recovery(Document& document, QString folder, QObject* parent)
    : QObject(parent), m_document(document), m_folder(std::move(folder)), m_runner(std::make_unique<JobRunner>())
{
    QDir().mkpath(m_folder);
    m_copy = m_folder + u'/' + QUuid::createUuid().toString(QUuid::WithoutBraces) + QStringLiteral(".mirrorball");
    m_lock = std::make_unique<QLockFile>(lockOf(m_copy));
    m_lock->setStaleLockTime(0); // only a process that is gone makes it stale
    m_lock->tryLock(0);
    m_soon.setSingleShot(true);
    m_soon.setInterval(1000 * std::clamp(QSettings().value(secondsKey, 1).toInt(), leastSeconds, mostSeconds));
    connect(&m_soon, &QTimer::timeout, this, &Recovery::write);
    connect(&m_document, &Document::changed, this, &Recovery::follow);
    connect(&m_document, &Document::modifiedChanged, this, &Recovery::follow);
}

Recovery::~Recovery()
{
    m_runner.reset(); // waits for a copy that is being written
    QFile::remove(m_copy);
    m_lock.reset();
}

void Recovery::setSeconds(int seconds)
{
    m_soon.setInterval(1000 * std::clamp(seconds, leastSeconds, mostSeconds)); // a running timer starts anew
    QSettings().setValue(secondsKey, this->seconds());
}

void Recovery::follow()
{
    if (m_document.isModified()) {
        if (!m_soon.isActive())
            m_soon.start();
        return;
    }
    m_soon.stop();
    m_runner->start(
        [copy = m_copy](const JobControl&) {
            QFile::remove(copy);
            return 0;
        },
        [](int) {});
}

void Recovery::write()
{
    Scene scene = m_document.scene();
    scene.unknown[originalKey] = quoted(m_document.filePath());
    m_runner->start(
        [scene = std::move(scene), copy = toPath(m_copy)](const JobControl&) {
            saveScene(scene, copy);
            return 0;
        },
        [](int) {});
}

std::vector<Recovery::Found> Recovery::found() const
{
    std::vector<Found> all;
    for (const QFileInfo& file : QDir(m_folder).entryInfoList({QStringLiteral("*.mirrorball")}, QDir::Files, QDir::Time)) {
        const QString copy = file.absoluteFilePath();
        if (copy == QFileInfo(m_copy).absoluteFilePath())
            continue;
        QLockFile lock(lockOf(copy));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0)) // its program lives
            continue;
        try {
            Scene scene = loadScene(toPath(copy));
            all.push_back({copy, takeOriginal(scene), file.lastModified()});
        } catch (const Error&) {
            // not one of ours; it stays where it is
        }
    }
    return all;
}

void Recovery::restore(const Found& found)
{
    Scene scene = loadScene(toPath(found.copy));
    takeOriginal(scene);
    m_document.recover(scene, found.original);
    write();
    discard(found);
}

void Recovery::discard(const Found& found)
{
    QFile::remove(found.copy);
    QFile::remove(lockOf(found.copy));
}

} // namespace mirrorball::studio
