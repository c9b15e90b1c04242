#pragma once

#include "widgets/workspace/workspace.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include <functional>
#include <vector>

namespace mirrorball::studio {

/// A tour that does a real job: a light is chosen and turned, a material and the kind of its map, and maps are written. It stands as a
/// strip above the picture and blocks nothing. A step waits until the user has done it, by whatever way; it can be shown, or skipped.
class Tour : public QFrame {
    Q_OBJECT

public:
    explicit Tour(Workspace& workspace, QWidget* parent = nullptr);

    /// Begins at the first step, whatever was seen before.
    void start();
    /// Starts for who has never seen it: once, ever.
    void greet();
    void end();
    bool isRunning() const { return m_step >= 0; }
    int step() const { return m_step; }
    int steps() const { return static_cast<int>(m_steps.size()); }
    /// Maps were written: the last step, which no scene shows.
    void noteExport();

signals:
    /// The user wants to see where: a dock's id, and a control in it by its name; "export" is the dialog.
    void showRequested(const QString& dock, const QString& control);

private:
    struct Step {
        QString text;
        QString dock;
        QString control;
        std::function<bool(const Scene& before, const Scene& now)> isDone; ///< by what has changed since the step began
    };
    static std::vector<Step> makeSteps();
    void go(int step);
    void look();

    Workspace& m_workspace;
    std::vector<Step> m_steps;
    int m_step = -1; ///< none: it does not run
    Scene m_before{};
    bool m_hasExported = false;
    QLabel* m_number;
    QLabel* m_text;
    QPushButton* m_show;
    QPushButton* m_skip;
};

} // namespace mirrorball::studio
