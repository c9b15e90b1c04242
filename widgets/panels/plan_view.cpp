#include "plan_view.h"

#include "widgets/controls/text.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include <algorithm>

namespace mirrorball::studio {

namespace {

/// Whether a measured stage is part of a planned one: "synthesis of specular map" belongs to "filter specular map".
bool belongs(const Stage& measured, const Stage& planned, const std::vector<Stage>& plan)
{
    if (measured.name == planned.name)
        return true;
    const auto of = measured.name.rfind(" of ");
    const std::string verb = measured.name.substr(0, of);
    if (of == std::string::npos || verb == "mip levels")
        return (measured.name == "repair" || measured.name == "prepare probe" || measured.name.find("probe") != std::string::npos) &&
               planned.name.find("probe") != std::string::npos &&
               std::none_of(plan.begin(), plan.end(), [&](const Stage& s) { return s.name == measured.name; });
    if (verb == "spectrum")
        return planned.name == "spectrum";
    return planned.name == "filter " + measured.name.substr(of + 4);
}

QString timeText(double seconds)
{
    const double ms = seconds * 1e3;
    return QStringLiteral("%1 ms").arg(ms, 0, 'f', ms < 10.0 ? 2 : ms < 100.0 ? 1 : 0);
}

} // namespace

std::vector<PlanRow> planRows(const MadeScene& made, double drawSeconds)
{
    std::vector<PlanRow> rows;
    const std::vector<Stage> plan = made.plan.stages();
    for (const Stage& planned : plan) {
        PlanRow row{.name = labelText(planned.name), .why = toQString(planned.why), .isLeftOut = planned.leftOut};
        if (planned.name == "draw") {
            row.seconds = drawSeconds;
        } else if (!planned.leftOut) {
            bool any = false;
            double seconds = 0.0;
            for (const Stage& measured : made.record.stages)
                if (!measured.leftOut && belongs(measured, planned, plan)) {
                    any = true;
                    seconds += measured.seconds;
                }
            row.isKept = !any;
            row.seconds = any ? seconds : -1.0;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

PlanView::PlanView(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_stages(new QTreeWidget(this)), m_total(new QLabel(this))
{
    m_stages->setObjectName(QStringLiteral("planStages"));
    m_stages->setAccessibleName(tr("Stages of the plan"));
    m_stages->setToolTip(tr("What the picture needs, what is left out and why, and how long each stage took"));
    m_stages->setHeaderLabels({tr("Stage"), tr("Time"), tr("Why")});
    m_stages->setRootIsDecorated(false);
    m_stages->setUniformRowHeights(true);
    m_stages->setFrameShape(QFrame::NoFrame);
    m_stages->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_stages->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_stages->header()->setStretchLastSection(true);
    m_total->setContentsMargins(10, 4, 10, 6);
    m_total->setProperty("role", QStringLiteral("footnote"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_stages, 1);
    column->addWidget(m_total);

    m_soon.setSingleShot(true);
    m_soon.setInterval(250);
    connect(&m_soon, &QTimer::timeout, this, &PlanView::refresh);
    connect(&m_workspace.live, &LiveScene::updated, this, [this] {
        if (!m_soon.isActive())
            m_soon.start();
    });
    refresh();
}

void PlanView::setDrawTime(double seconds)
{
    m_drawSeconds = seconds;
    if (!m_soon.isActive())
        m_soon.start();
}

void PlanView::refresh()
{
    const auto made = m_workspace.live.made();
    if (!made) {
        m_total->setText(tr("The plan appears with the first picture."));
        return;
    }
    if (!isVisible() && m_stages->topLevelItemCount() > 0)
        return;
    const std::vector<PlanRow> rows = planRows(*made, m_drawSeconds);
    while (m_stages->topLevelItemCount() > static_cast<int>(rows.size()))
        delete m_stages->takeTopLevelItem(m_stages->topLevelItemCount() - 1);
    double total = 0.0;
    int leftOut = 0;
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const PlanRow& row = rows[static_cast<size_t>(i)];
        QTreeWidgetItem* item = m_stages->topLevelItem(i);
        if (!item) {
            item = new QTreeWidgetItem(m_stages);
            item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        }
        const QString time = row.isLeftOut        ? tr("left out")
                             : row.isKept         ? tr("kept")
                             : row.seconds >= 0.0 ? timeText(row.seconds)
                                                  : QString();
        item->setText(0, row.name);
        item->setText(1, time);
        item->setText(2, row.why);
        item->setToolTip(2, row.why);
        item->setToolTip(0, row.why);
        const QBrush brush = palette().brush(row.isLeftOut ? QPalette::PlaceholderText : QPalette::Text);
        for (int column = 0; column < 3; ++column)
            item->setForeground(column, column == 2 ? palette().brush(QPalette::PlaceholderText) : brush);
        total += std::max(0.0, row.seconds);
        leftOut += row.isLeftOut;
    }
    m_total->setText(tr("Last update: %1. Left out: %2 of %3 stages.").arg(timeText(total)).arg(leftOut).arg(rows.size()));
}

} // namespace mirrorball::studio
