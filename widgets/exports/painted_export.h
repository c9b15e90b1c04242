#pragma once

#include "widgets/workspace/job_runner.h"
#include "widgets/workspace/workspace.h"

#include "core/spheremap/evaluation/painted_pictures.h"

#include <QWidget>

namespace mirrorball::studio {

/// Hands the scene's sphere map to another program: asks for a file and writes the picture, at the scene's size, in the background. What
/// goes wrong is told by a notice.
class PaintedExport : public QObject {
    Q_OBJECT

public:
    /// @param window  over which the file is asked for
    PaintedExport(Workspace& workspace, QWidget* window);

    void askAndWrite();
    void write(const QString& path, PaintedLevels levels);

signals:
    void written(const QString& path);

private:
    Workspace& m_workspace;
    QWidget* m_window;
    JobRunner m_runner;
};

} // namespace mirrorball::studio
