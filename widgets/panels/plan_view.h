#pragma once

#include "widgets/picture/preview_widget.h"
#include "widgets/workspace/workspace.h"

#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

namespace mirrorball::studio {

/// One stage of the plan as it is shown.
struct PlanRow {
    QString name;
    QString why;
    bool isLeftOut = false;
    bool isKept = false;   ///< made by an earlier update
    double seconds = -1.0; ///< of this update; negative: not measured
};

/// The stages of a scene's plan with the times of its last update beside them.
std::vector<PlanRow> planRows(const MadeScene& made, double drawSeconds);

/// The plan, live: which stages the picture needs, what is left out and why, how long each took.
class PlanView : public QWidget {
    Q_OBJECT

public:
    explicit PlanView(Workspace& workspace, QWidget* parent = nullptr);
    /// Tells how long the last picture took to draw.
    void setDrawTime(double seconds);

private:
    void refresh();

    Workspace& m_workspace;
    QTreeWidget* m_stages;
    QLabel* m_total;
    double m_drawSeconds = -1.0;
    QTimer m_soon; ///< a drag makes dozens of plans a second; nobody reads them that fast
};

} // namespace mirrorball::studio
