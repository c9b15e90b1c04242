#pragma once

#include "method_chart.h"
#include "method_table.h"
#include "widgets/controls/options_form.h"
#include "widgets/workspace/job_runner.h"
#include "widgets/workspace/workspace.h"

#include "core/report/method_race.h"

#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <vector>

namespace mirrorball::studio {

/// The Report dock: error against run time of every method for the material as it stands, measured in the background while the dock is
/// seen. A click on a point chooses the method of the scene, as an undo step; its signed error is shown in the Map dock, its command line
/// can be copied.
class ReportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ReportPanel(Workspace& workspace, QWidget* parent = nullptr);

    MethodChart& chart() { return *m_chart; }
    const std::vector<RacePoint>& points() const { return m_points; }
    /// Whether measurements are under way or due.
    bool isMeasuring() const { return m_isMeasuring; }
    QString statusText() const { return m_status->text(); }
    /// Index of the picked point, or -1.
    int picked() const { return m_picked; }

    QSize sizeHint() const override { return {420, 480}; }

public slots:
    /// Picks a point: the scene is filtered by it from now on, and its error is shown. One that would take long at the scene's size is
    /// chosen by use() only.
    void pick(int index);
    /// The picked setting becomes the scene's.
    void use();
    /// Measures anew from the start.
    void measure();
    void stop();

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    static QString waitingText();
    QScrollArea* makeSide();
    OptionsForm* makeForm();
    void addTolerance(OptionsForm& form);
    void follow();
    void start();
    void measureNext(size_t setting);
    void giveWay();
    void goOn();
    void add(const RacePoint& point);
    void finish(const QString& status);
    void showPicked();
    void copyCommand();
    QString describe(const RacePoint& point) const;
    double secondsAtFullSize(const RacePoint& point) const;

    Workspace& m_workspace;
    JobRunner m_runner;      ///< measures, one setting after the other
    JobRunner m_errorRunner; ///< the signed error of what was picked
    QSplitter* m_splitter;
    MethodChart* m_chart;
    MethodTable* m_table;
    QLabel *m_status, *m_facts;
    QProgressBar* m_progress;
    QPushButton *m_again, *m_stop, *m_copy, *m_use;
    std::shared_ptr<MethodRace> m_race; ///< used by one worker at a time
    std::vector<RacePoint> m_points;
    Scene m_measured{}; ///< what the points are of
    QTimer m_rest;      ///< runs out when the scene has been left alone for a while
    size_t m_next = 0;  ///< the setting that is being measured
    bool m_isMeasuring = false;
    bool m_gaveWay = false;    ///< measuring waits for the end of a drag
    bool m_isArranged = false; ///< the splitter has its first sizes
    int m_picked = -1;
};

} // namespace mirrorball::studio
