#pragma once

#include "job_runner.h"

#include <QAbstractListModel>
#include <QFileSystemWatcher>
#include <QImage>
#include <QStringList>
#include <QTimer>

#include <deque>
#include <vector>

namespace mirrorball::studio {

/// Whether the name of a file says that it holds an image that can be a probe.
bool isProbeFile(const QString& path);

/// The probes that a user can choose from: the built-in ones, single files, and those in some folders, which are watched. Files and folders
/// are kept between runs. A thumbnail is made in the background when a view first asks for it, the last one asked for first, and kept on
/// disk.
class ProbeLibrary : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        SourceRole = Qt::UserRole, ///< QString as a scene names it: "builtin:NAME" or an absolute path
        GroupRole,                 ///< QString: builtinGroup(), filesGroup() or a folder
        FactsRole,                 ///< QString, one line: "latlong 1024 x 512"
        ProblemRole,               ///< QString: why there is no thumbnail; empty
        CertainRole,               ///< bool: whether its parameterization is known
    };

    explicit ProbeLibrary(QObject* parent = nullptr);
    ~ProbeLibrary() override;

    static QString builtinGroup() { return QStringLiteral("builtin"); }
    static QString filesGroup() { return QStringLiteral("files"); }

    const QStringList& folders() const { return m_folders; }
    void addFolder(const QString& path);
    void removeFolder(const QString& path);
    /// A single file, dropped or of a scene; once, and not when it lies in one of the folders.
    void addFile(const QString& path);
    void removeFile(const QString& path);
    /// Single files of the list that are not there any more.
    QStringList missingFiles() const;
    /// The row of a source, or -1.
    int rowOf(const QString& source) const;
    /// Makes the thumbnail of a file that changed anew.
    void refresh(const QString& source);
    /// Whether thumbnails are being made.
    bool isBusy() const { return m_isLoading || !m_queue.empty(); }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

signals:
    void foldersChanged();

private:
    struct Entry {
        QString source, name, group;
        enum class State { Unknown, Asked, Ready, Broken } state = State::Unknown;
        QImage thumbnail{};
        QString facts{}, problem{};
        bool isCertain = true;
    };
    struct Loaded {
        QImage thumbnail{};
        QString facts{}, problem{};
        bool isCertain = true;
    };

    static Loaded load(const QString& source, const JobControl& job);
    void scan();
    void ask(int row);
    void loadNext();
    void loaded(const QString& source, const Loaded& result);
    void save() const;

    std::vector<Entry> m_entries;
    QStringList m_folders, m_files;
    QFileSystemWatcher m_watcher;
    QTimer m_scanSoon;
    JobRunner m_runner;
    std::deque<QString> m_queue;
    bool m_isLoading = false;
};

} // namespace mirrorball::studio
