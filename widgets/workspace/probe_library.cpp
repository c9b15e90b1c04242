#include "probe_library.h"

#include "widgets/controls/image_patterns.h"
#include "widgets/controls/images.h"
#include "widgets/controls/text.h"

#include "core/base/error.h"
#include "core/image/builtin_probes.h"
#include "core/image/color.h"
#include "core/image/thumbnail.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mirrorball::studio {

namespace {

constexpr int thumbnailHeight = 128;
constexpr int mostFiles = 2000;      ///< of one folder
constexpr int keptThumbnails = 4000; ///< on disk; about 30 kB each

/// As bright as a picture in a contact sheet: the middle of its luminances is a mid gray, whatever a sun may be.
QImage developed(const EnvironmentMap& map)
{
    std::vector<double> luminances;
    for (size_t i = 0; i + 2 < map.image.texels.size(); i += 3)
        luminances.push_back(luminance({map.image.texels[i], map.image.texels[i + 1], map.image.texels[i + 2]}));
    const auto middle = luminances.begin() + static_cast<ptrdiff_t>(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    const double exposure = *middle > 0.0 ? std::clamp(std::log2(0.22 / *middle), -14.0, 14.0) : 0.0;
    return toQImage(toDisplay(map.image, exposure, ToneCurve::Filmic)).convertToFormat(QImage::Format_RGB32);
}

QString cacheFolder() { return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails"); }

/// Where the thumbnail of a file as it is now is kept.
QString cachePath(const QString& source)
{
    const QFileInfo file(source);
    const QString key = QStringLiteral("2|%1|%2|%3|%4")
                            .arg(file.absoluteFilePath())
                            .arg(file.lastModified().toMSecsSinceEpoch())
                            .arg(file.size())
                            .arg(thumbnailHeight);
    return cacheFolder() + QLatin1Char('/') +
           QString::fromLatin1(QCryptographicHash::hash(key.toUtf8(), QCryptographicHash::Sha1).toHex()) + QStringLiteral(".png");
}

void keep(const QString& path, const QImage& thumbnail)
{
    QDir().mkpath(cacheFolder());
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && thumbnail.save(&file, "PNG"))
        file.commit(); // a cache that cannot be written is no error: the thumbnail is made again next time
}

void prune()
{
    const QFileInfoList kept = QDir(cacheFolder()).entryInfoList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
    for (qsizetype i = keptThumbnails; i < kept.size(); ++i)
        QFile::remove(kept[i].absoluteFilePath());
}

} // namespace

bool isProbeFile(const QString& path) { return QDir::match(imagePatterns(), QFileInfo(path).fileName()); }

ProbeLibrary::ProbeLibrary(QObject* parent) : QAbstractListModel(parent), m_runner(this)
{
    const QSettings settings;
    m_folders = settings.value(QStringLiteral("probes/folders")).toStringList();
    m_files = settings.value(QStringLiteral("probes/files")).toStringList();
    m_scanSoon.setSingleShot(true);
    m_scanSoon.setInterval(200);
    connect(&m_scanSoon, &QTimer::timeout, this, &ProbeLibrary::scan);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_scanSoon, qOverload<>(&QTimer::start));
    scan();
}

ProbeLibrary::~ProbeLibrary() = default;

void ProbeLibrary::save() const
{
    QSettings settings;
    settings.setValue(QStringLiteral("probes/folders"), m_folders);
    settings.setValue(QStringLiteral("probes/files"), m_files);
}

void ProbeLibrary::addFolder(const QString& path)
{
    const QString folder = QDir(path).absolutePath();
    if (m_folders.contains(folder))
        return;
    m_folders << folder;
    save();
    scan();
    emit foldersChanged();
}

void ProbeLibrary::removeFolder(const QString& path)
{
    if (m_folders.removeAll(path) == 0)
        return;
    save();
    scan();
    emit foldersChanged();
}

void ProbeLibrary::addFile(const QString& path)
{
    const QString file = QFileInfo(path).absoluteFilePath();
    if (rowOf(file) >= 0)
        return;
    m_files << file;
    save();
    scan();
}

void ProbeLibrary::removeFile(const QString& path)
{
    if (m_files.removeAll(path) == 0)
        return;
    save();
    scan();
}

QStringList ProbeLibrary::missingFiles() const
{
    QStringList missing;
    std::copy_if(m_files.begin(), m_files.end(), std::back_inserter(missing), [](const QString& file) { return !QFileInfo::exists(file); });
    return missing;
}

int ProbeLibrary::rowOf(const QString& source) const
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.source == source; });
    return found == m_entries.end() ? -1 : static_cast<int>(found - m_entries.begin());
}

/// The list anew, with what is known already.
void ProbeLibrary::scan()
{
    std::vector<Entry> entries;
    const auto add = [&](const QString& source, const QString& name, const QString& group) {
        if (const int row = rowOf(source); row >= 0) {
            entries.push_back(m_entries[static_cast<size_t>(row)]);
            entries.back().group = group;
        } else {
            entries.push_back({.source = source, .name = name, .group = group});
        }
    };
    for (const BuiltinProbe& probe : builtinProbes())
        add(QStringLiteral("builtin:") + toQString(probe.name), toQString(probe.name), builtinGroup());
    for (const QString& folder : m_folders) {
        const QFileInfoList files =
            QDir(folder).entryInfoList(imagePatterns(), QDir::Files | QDir::Readable, QDir::Name | QDir::IgnoreCase);
        for (qsizetype i = 0; i < std::min<qsizetype>(files.size(), mostFiles); ++i)
            add(files[i].absoluteFilePath(), files[i].fileName(), folder);
    }
    for (const QString& file : m_files)
        if (std::none_of(entries.begin(), entries.end(), [&](const Entry& e) { return e.source == file; }))
            add(file, QFileInfo(file).fileName(), filesGroup());
    beginResetModel();
    m_entries = std::move(entries);
    endResetModel();

    const QStringList watched = m_watcher.directories();
    for (const QString& folder : watched)
        if (!m_folders.contains(folder))
            m_watcher.removePath(folder);
    for (const QString& folder : m_folders)
        if (!watched.contains(folder) && QDir(folder).exists())
            m_watcher.addPath(folder);
}

void ProbeLibrary::refresh(const QString& source)
{
    const int row = rowOf(source);
    if (row < 0)
        return;
    m_entries[static_cast<size_t>(row)].state = Entry::State::Unknown; // its old picture stands until the new one is there
    emit dataChanged(index(row), index(row));
}

int ProbeLibrary::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(m_entries.size()); }

QVariant ProbeLibrary::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Entry& entry = m_entries[static_cast<size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return entry.name;
    case Qt::DecorationRole:
        if (entry.state == Entry::State::Unknown) // asking is no change that a view could see
            const_cast<ProbeLibrary*>(this)->ask(index.row());
        return entry.thumbnail.isNull() ? QVariant() : QVariant(entry.thumbnail);
    case Qt::ToolTipRole:
        if (entry.group == builtinGroup())
            return toQString(builtinProbe(entry.name.toStdString()).description);
        return entry.problem.isEmpty() ? QDir::toNativeSeparators(entry.source) : entry.problem;
    case Qt::AccessibleTextRole:
        return entry.name + QStringLiteral(", ") + (entry.problem.isEmpty() ? entry.facts : entry.problem);
    case SourceRole:
        return entry.source;
    case GroupRole:
        return entry.group;
    case FactsRole:
        return entry.facts;
    case ProblemRole:
        return entry.problem;
    case CertainRole:
        return entry.isCertain;
    default:
        return {};
    }
}

void ProbeLibrary::ask(int row)
{
    Entry& entry = m_entries[static_cast<size_t>(row)];
    entry.state = Entry::State::Asked;
    m_queue.push_front(entry.source);
    if (!m_isLoading)
        loadNext();
}

ProbeLibrary::Loaded ProbeLibrary::load(const QString& source, const JobControl& job)
{
    const bool isFile = !source.startsWith(QStringLiteral("builtin:"));
    const QString kept = cachePath(source);
    Loaded result;
    if (isFile && QFileInfo::exists(kept)) {
        const QImage image(kept);
        if (!image.isNull()) {
            result.thumbnail = image.convertToFormat(QImage::Format_RGB32);
            result.facts = image.text(QStringLiteral("facts"));
            result.isCertain = image.text(QStringLiteral("certain")) != QStringLiteral("no");
            return result;
        }
    }
    try {
        const ReducedProbe probe = reduceProbe(isFile ? toPath(source).string() : source.toStdString(), {.height = thumbnailHeight}, job);
        result.thumbnail = developed(thumbnailOf(probe, thumbnailHeight, {}, job));
        result.facts =
            QStringLiteral("%1 %2 × %3").arg(toQString(name(probe.detection.layout.kind))).arg(probe.info.width).arg(probe.info.height);
        result.isCertain = probe.detection.certain;
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) { // of this file only: the others follow
        result.problem = QString::fromUtf8(error.what());
        return result;
    }
    if (isFile) {
        QImage image = result.thumbnail;
        image.setText(QStringLiteral("facts"), result.facts);
        image.setText(QStringLiteral("certain"), result.isCertain ? QStringLiteral("yes") : QStringLiteral("no"));
        keep(kept, image);
    }
    return result;
}

void ProbeLibrary::loadNext()
{
    if (m_queue.empty()) {
        m_isLoading = false;
        return;
    }
    m_isLoading = true;
    const QString source = m_queue.front();
    m_queue.pop_front();
    m_runner.start(
        [source, isLast = m_queue.empty()](const JobControl& job) {
            JobControl one = job;
            one.threads = 1; // the picture and the filters come first
            Loaded result = load(source, one);
            if (isLast)
                prune();
            return result;
        },
        [this, source](const Loaded& result) { loaded(source, result); }, Running::Finish);
}

void ProbeLibrary::loaded(const QString& source, const Loaded& result)
{
    if (const int row = rowOf(source); row >= 0) {
        Entry& entry = m_entries[static_cast<size_t>(row)];
        entry.state = result.problem.isEmpty() ? Entry::State::Ready : Entry::State::Broken;
        entry.thumbnail = result.thumbnail;
        entry.facts = result.facts;
        entry.problem = result.problem;
        entry.isCertain = result.isCertain;
        emit dataChanged(index(row), index(row));
    }
    loadNext();
}

} // namespace mirrorball::studio
