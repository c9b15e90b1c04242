#pragma once

#include "job_runner.h"

#include <QHash>
#include <QIcon>
#include <QObject>
#include <QString>

#include <deque>

namespace mirrorball::studio {

/// Small pictures of bodies, of those that are built in and of mesh files. Each is made in the background when it is first asked for, and
/// kept while the program runs; a file's anew once it has changed. A mesh that cannot be read has none.
class MeshThumbnails : public QObject {
    Q_OBJECT

public:
    static constexpr int pictureEdge = 32; ///< on the screen; made for screens of up to twice the density

    explicit MeshThumbnails(QObject* parent = nullptr);
    ~MeshThumbnails() override;

    /// The picture of "teapot", "torus", "sphere", "box" or a mesh file's absolute path; null while it is being made, which made() ends,
    /// and for what has none.
    QIcon icon(const QString& geometry);
    /// Whether pictures are being made.
    bool isBusy() const { return m_isMaking; }

signals:
    void made(const QString& geometry);

private:
    struct Entry {
        QIcon icon{};
        qint64 time = 0; ///< of the file that it shows
    };
    void makeNext();

    QHash<QString, Entry> m_entries;
    std::deque<QString> m_queue;
    bool m_isMaking = false;
    JobRunner m_runner; ///< last: it ends first
};

} // namespace mirrorball::studio
