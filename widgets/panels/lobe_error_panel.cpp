#include "lobe_error_panel.h"

#include "chart_style.h"

#include "widgets/controls/keep_place.h"
#include "widgets/controls/text.h"

#include "core/base/shell_word.h"
#include "core/report/curve_picture.h"
#include "core/scene/scene.h"
#include "core/shading/brdf_file.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QVBoxLayout>
#include <QtCharts/QLegend>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr int restTime = 700; ///< ms: who looks for a value is not disturbed by measurements of those on the way
constexpr int rows = 64;      ///< of the probe that is summed: enough to judge by while one waits

/// Of the picture's lookups and what stands beside them; each once.
std::vector<LookupChoice> choicesFor(int lookups)
{
    std::vector<LookupChoice> choices{{LookupKind::Fitted, lookups}};
    if (lookups != 3)
        choices.push_back({LookupKind::Fitted, 3});
    for (const LookupKind kind : {LookupKind::SplitSum, LookupKind::Three, LookupKind::Filament})
        choices.push_back({kind});
    return choices;
}

QString choiceText(const LookupChoice& choice)
{
    if (choice.kind == LookupKind::Fitted)
        return LobeErrorPanel::tr("Lookups: %1").arg(choice.count);
    return labelText(wordOf(choice.kind));
}

/// The hue of a line on dark gray.
QColor colorOf(size_t i)
{
    const glm::vec3 c = curveColor(i);
    return QColor::fromRgbF(c.r, c.g, c.b).lighter(125);
}

} // namespace

LobeErrorPanel::LobeErrorPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_runner(this), m_chart(new QChartView), m_view(new QValueAxis(this)),
      m_error(new QLogValueAxis(this)), m_table(new QTreeWidget), m_status(new QLabel), m_progress(new QProgressBar),
      m_copy(new QPushButton(tr("&Copy command")))
{
    buildChart();
    m_table->setObjectName(QStringLiteral("lobe_error.table"));
    m_table->setAccessibleName(tr("Errors of the lookups"));
    m_table->setToolTip(tr("rel_rms by angle of view, in degrees: 0.01 is a hundredth of the light, all over the sphere"));
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    m_table->setMinimumHeight(60);
    m_table->header()->setStretchLastSection(false);
    m_table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->header()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_status->setWordWrap(true);
    m_status->setObjectName(QStringLiteral("lobe_error.status"));
    makeSlim(*m_progress);
    m_progress->setAccessibleName(tr("Measuring"));
    m_progress->hide();
    m_copy->setObjectName(QStringLiteral("lobe_error.copy"));
    m_copy->setAccessibleName(m_copy->text().remove(u'&'));
    m_copy->setToolTip(tr("Copies the command line that measures the same"));

    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_status);
    column->addWidget(m_progress);
    column->addWidget(m_table, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_copy);
    buttons->addStretch(1);
    column->addLayout(buttons);
    auto* splitter = new QSplitter;
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_chart);
    splitter->addWidget(side);
    splitter->setSizes({400, 360});
    splitter->setStretchFactor(0, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(splitter);

    m_rest.setSingleShot(true);
    m_rest.setInterval(restTime);
    connect(&m_rest, &QTimer::timeout, this, &LobeErrorPanel::measure);
    connect(&workspace.document, &Document::changed, this, [this] { // what an edit wants of the processor comes first
        m_rest.stop();
        m_runner.stop();
    });
    connect(&workspace.live, &LiveScene::updated, this, &LobeErrorPanel::follow);
    connect(&workspace.document, &Document::dragFinished, this, &LobeErrorPanel::follow);
    connect(&m_runner, &JobRunner::busyChanged, m_progress, &QWidget::setVisible);
    connect(&m_runner, &JobRunner::progressed, this, [this](double share) { m_progress->setValue(static_cast<int>(100.0 * share)); });
    connect(&m_runner, &JobRunner::failed, this, &LobeErrorPanel::clear);
    connect(m_copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(command()); });
    clear(tr("The material is measured once it has come to rest."));
}

void LobeErrorPanel::buildChart()
{
    m_chart->setObjectName(QStringLiteral("lobe_error.chart"));
    m_chart->setAccessibleName(tr("Error over angle of view"));
    m_chart->setToolTip(tr("How far the light that lookups give is from the integral of the BRDF over the probe, by the angle between "
                           "surface normal and view; further down is more accurate"));
    m_chart->setMinimumSize(200, 120);
    styleChart(*m_chart);
    QChart* chart = m_chart->chart();
    chart->legend()->hide(); // the table beside it has the lookups in their colors
    m_error->setBase(10.0);
    m_error->setMinorTickCount(0);
    m_error->setLabelFormat(QStringLiteral("%g"));
    m_error->setTitleText(tr("rel_rms"));
    m_error->setRange(1e-3, 1.0);
    m_view->setRange(0.0, 75.0);
    m_view->setTickCount(6);
    m_view->setLabelFormat(QStringLiteral("%.0f"));
    m_view->setTitleText(tr("angle of view, degrees"));
    for (QAbstractAxis* axis : {static_cast<QAbstractAxis*>(m_view), static_cast<QAbstractAxis*>(m_error)})
        styleAxis(*axis, font());
    chart->addAxis(m_view, Qt::AlignBottom);
    chart->addAxis(m_error, Qt::AlignLeft);
}

LobeErrorPanel::Subject LobeErrorPanel::subject() const
{
    const BrdfSettings& brdf = m_workspace.document.scene().material.brdf;
    const auto made = m_workspace.live.made();
    return {brdf.model, std::max(brdf.lookups, 1), made ? made->environment : nullptr};
}

void LobeErrorPanel::showEvent(QShowEvent*) { follow(); }

void LobeErrorPanel::follow()
{
    if (!isVisible() || !m_workspace.live.isUpToDate() || m_workspace.document.isDragging())
        return; // the end of the drag, the new maps or the panel's showing call again
    const Subject now = subject();
    if (m_measured == now && m_errors)
        return;
    if (now.model.empty())
        return clear(
            tr("The material has no BRDF: its specular lobe is the round one that the map holds. Choose a BRDF in the Material panel."));
    if (!now.environment)
        return clear(tr("The probe is too large to be held whole; the command line measures it."));
    m_rest.start();
}

void LobeErrorPanel::measure()
{
    const Subject now = subject();
    if (!isVisible() || now.model.empty() || !now.environment)
        return;
    m_status->setText(tr("Measuring %1…").arg(toQString(now.model)));
    m_runner.start(
        [scene = m_workspace.document.scene(), now](const JobControl& job) {
            return measureBrdfErrors(*now.environment, brdfOf(scene),
                                     {.choices = choicesFor(now.lookups), .viewsDeg = {0, 15, 30, 45, 60, 75}, .height = rows}, job);
        },
        [this, now](const BrdfErrors& errors) {
            m_measured = now;
            draw(errors);
        });
}

void LobeErrorPanel::draw(const BrdfErrors& errors)
{
    m_errors = errors;
    QChart* chart = m_chart->chart();
    chart->removeAllSeries();
    m_table->clear();
    QStringList titles{tr("Lookups")};
    for (const double view : errors.viewsDeg)
        titles << tr("%1°").arg(view);
    m_table->setHeaderLabels(titles);
    double least = 1e-2, most = 0.1;
    for (size_t c = 0; c < errors.choices.size(); ++c) {
        auto* series = new QLineSeries;
        series->setName(choiceText(errors.choices[c]));
        series->setPen(QPen(colorOf(c), 2.0));
        series->setPointsVisible(true);
        auto* row = new QTreeWidgetItem({choiceText(errors.choices[c])});
        row->setForeground(0, colorOf(c));
        for (size_t v = 0; v < errors.viewsDeg.size(); ++v) {
            const double error = errors.relRms[c][v];
            series->append(errors.viewsDeg[v], std::max(error, 1e-6));
            row->setText(static_cast<int>(v) + 1, QString::number(error, 'f', 3));
            row->setTextAlignment(static_cast<int>(v) + 1, Qt::AlignRight | Qt::AlignVCenter);
            least = std::min(least, std::max(error, 1e-6));
            most = std::max(most, error);
        }
        m_table->addTopLevelItem(row);
        chart->addSeries(series);
        series->attachAxis(m_view);
        series->attachAxis(m_error);
    }
    m_error->setRange(std::pow(10.0, std::floor(std::log10(least))), std::pow(10.0, std::ceil(std::log10(most))));
    m_copy->setEnabled(true);
    m_status->setText(
        tr("%1: error against the sum over every texel of the probe, averaged to %2 rows.").arg(toQString(errors.model)).arg(rows));
}

void LobeErrorPanel::clear(const QString& status)
{
    m_errors.reset();
    m_chart->chart()->removeAllSeries();
    m_table->clear();
    m_table->setHeaderLabels({tr("Lookups")});
    m_copy->setEnabled(false);
    m_status->setText(status);
}

QString LobeErrorPanel::command() const
{
    const Scene& scene = m_workspace.document.scene();
    const std::string& model = m_measured->model;
    std::string text = "mirrorball brdf " + shellWord(isBrdfFile(model) ? resolved(scene, model) : model) + " --errors " +
                       shellWord(resolved(scene, scene.probe.source)) + " --height " + std::to_string(rows) + " --lookups ";
    for (size_t i = 0; i < m_errors->choices.size(); ++i)
        text += (i > 0 ? "," : "") + describe(m_errors->choices[i]);
    return toQString(text);
}

} // namespace mirrorball::studio
