#pragma once

#include "widgets/workspace/workspace.h"

#include <QObject>
#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

namespace mirrorball::studio {

/// What becomes of files that are dropped anywhere on a window. Images become the probe, a folder joins the library of probes; a window
/// adds what else it can open.
class DropTarget : public QObject {
    Q_OBJECT

public:
    /// @param window  outlives this; gets the drops of all its children that take none themselves
    DropTarget(QWidget& window, Workspace& workspace);

    /// Opens one path; false when it is not one of its kind. Asked in the order of adding, before images and folders.
    using Opener = std::function<bool(const QString& path)>;
    void addOpener(Opener opener) { m_openers.push_back(std::move(opener)); }

    /// Opens paths as if they were dropped. What cannot be opened is named among the notices.
    void open(const QStringList& paths);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool openOne(const QString& path);

    Workspace& m_workspace;
    std::vector<Opener> m_openers;
};

} // namespace mirrorball::studio
