#pragma once

#include "widgets/workspace/document.h"
#include "widgets/workspace/job_runner.h"

#include <QDateTime>
#include <QLockFile>
#include <QTimer>

#include <memory>
#include <vector>

namespace mirrorball::studio {

/// Keeps a copy of unsaved changes beside the user's files, a second - or as many as somebody prefers - after they were made, and finds the
/// copies that a program left which did not end by itself. A copy appears whole or not at all, and goes when its document is saved or
/// closed.
class Recovery : public QObject {
    Q_OBJECT

public:
    /// @param folder for the copies; made when missing
    Recovery(Document& document, QString folder, QObject* parent = nullptr);
    /// Ended by itself: nothing is left.
    ~Recovery() override;

    struct Found {
        QString copy;     ///< the file that holds the changes
        QString original; ///< the document's file; empty: it had none
        QDateTime time;
    };
    /// Copies whose program is gone, the newest first.
    std::vector<Found> found() const;
    /// Makes a copy the document, unsaved. @throws FileError
    void restore(const Found& found);
    void discard(const Found& found);

    static constexpr int leastSeconds = 1, mostSeconds = 600;
    /// How long after a change its copy is written.
    int seconds() const { return m_soon.interval() / 1000; }
    /// From now on and in the next run. @param seconds  brought into leastSeconds to mostSeconds
    void setSeconds(int seconds);

    const QString& copyPath() const { return m_copy; }
    static QString defaultFolder();

private:
    void follow();
    void write();

    Document& m_document;
    QString m_folder;
    QString m_copy;
    std::unique_ptr<QLockFile> m_lock; ///< says that this program is alive
    std::unique_ptr<JobRunner> m_runner;
    QTimer m_soon;
};

} // namespace mirrorball::studio
