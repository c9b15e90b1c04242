#pragma once

#include "widgets/workspace/job_runner.h"
#include "widgets/workspace/workspace.h"

#include "core/report/brdf_errors.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>
#include <QWidget>
#include <QtCharts/QChartView>
#include <QtCharts/QLineSeries>
#include <QtCharts/QLogValueAxis>
#include <QtCharts/QValueAxis>

#include <memory>
#include <optional>

namespace mirrorball::studio {

/// The Lobe error dock: what the lookups of the picture and those of engines miss of the material's BRDF in the light of the probe, over
/// the angle of view. Measured in the background while the dock is seen and the scene rests.
class LobeErrorPanel : public QWidget {
    Q_OBJECT

public:
    explicit LobeErrorPanel(Workspace& workspace, QWidget* parent = nullptr);

    /// What is drawn; nothing where the material has no BRDF, or before it is measured.
    const std::optional<BrdfErrors>& errors() const { return m_errors; }
    bool isMeasuring() const { return m_runner.isBusy() || m_rest.isActive(); }
    QString statusText() const { return m_status->text(); }

    QSize sizeHint() const override { return {420, 320}; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    /// What a measurement depends on.
    struct Subject {
        std::string model{};
        int lookups = 5;
        std::shared_ptr<const EnvironmentMap> environment{};
        bool operator==(const Subject&) const = default;
    };
    Subject subject() const;
    void buildChart();
    void follow();
    void measure();
    void draw(const BrdfErrors& errors);
    void clear(const QString& status);
    QString command() const;

    Workspace& m_workspace;
    JobRunner m_runner;
    QChartView* m_chart;
    QValueAxis* m_view;
    QLogValueAxis* m_error;
    QTreeWidget* m_table;
    QLabel* m_status;
    QProgressBar* m_progress;
    QPushButton* m_copy;
    QTimer m_rest; ///< runs out when the scene has been left alone for a while
    std::optional<Subject> m_measured{};
    std::optional<BrdfErrors> m_errors{};
};

} // namespace mirrorball::studio
