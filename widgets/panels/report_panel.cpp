#include "report_panel.h"

#include "widgets/controls/color_scale_bar.h"
#include "widgets/controls/keep_place.h"
#include "widgets/controls/scrolled.h"
#include "widgets/controls/text.h"

#include "core/report/report_forecast.h"
#include "core/scene/scene_dependencies.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QSplitter>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace mirrorball::studio {

namespace {

constexpr double longWait = 3.0; ///< seconds of filtering that nobody starts by a mere click
constexpr int restTime = 1000;   ///< ms: who looks for a value is not disturbed by measurements of those on the way
constexpr int measuredSize = 64; ///< texels: small enough to measure every method while one waits

} // namespace

ReportPanel::ReportPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_runner(this), m_errorRunner(this), m_splitter(new QSplitter), m_chart(new MethodChart),
      m_table(new MethodTable), m_status(new QLabel), m_facts(new QLabel), m_progress(new QProgressBar),
      m_again(new QPushButton(tr("Measure &again"))), m_stop(new QPushButton(tr("&Stop"))), m_copy(new QPushButton(tr("&Copy command"))),
      m_use(new QPushButton(tr("&Use it anyway")))
{
    m_chart->setObjectName(QStringLiteral("report.chart"));
    // Side by side below the picture, one above the other in a narrow dock.
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(m_chart);
    m_splitter->addWidget(m_table);
    m_splitter->addWidget(makeSide());
    m_splitter->setStretchFactor(0, 2);
    m_splitter->setStretchFactor(1, 1);
    m_splitter->setStretchFactor(2, 0);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_splitter);

    connect(m_chart, &MethodChart::picked, this, &ReportPanel::pick);
    connect(m_table, &MethodTable::picked, this, &ReportPanel::pick);
    connect(m_again, &QPushButton::clicked, this, &ReportPanel::measure);
    connect(m_use, &QPushButton::clicked, this, &ReportPanel::use);
    connect(m_stop, &QPushButton::clicked, this, &ReportPanel::stop);
    connect(m_copy, &QPushButton::clicked, this, &ReportPanel::copyCommand);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restTime);
    connect(&m_rest, &QTimer::timeout, this, &ReportPanel::goOn);
    connect(&workspace.document, &Document::changed, this, &ReportPanel::giveWay);
    connect(&workspace.live, &LiveScene::updated, this, &ReportPanel::follow);
    connect(&workspace.document, &Document::dragFinished, this, &ReportPanel::follow);
    connect(&m_runner, &JobRunner::failed, this, &ReportPanel::finish);
    connect(&m_errorRunner, &JobRunner::failed, m_facts, &QLabel::setText);
    m_stop->hide();
    m_status->setText(waitingText());
}

/// What stands beside chart and table: the state, the knobs of the scene's method, what is known of the picked one.
QScrollArea* ReportPanel::makeSide()
{
    m_status->setWordWrap(true);
    m_status->setObjectName(QStringLiteral("report.status"));
    m_facts->setWordWrap(true);
    m_facts->setObjectName(QStringLiteral("report.facts"));
    m_facts->setAccessibleName(tr("Facts of the chosen method"));
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    makeSlim(*m_progress);
    m_progress->setAccessibleName(tr("Measuring"));
    m_progress->hide();
    m_again->setObjectName(QStringLiteral("report.again"));
    m_again->setToolTip(tr("Measures every method anew"));
    m_stop->setObjectName(QStringLiteral("report.stop"));
    m_stop->setToolTip(tr("Stops measuring; what is measured stays"));
    m_copy->setObjectName(QStringLiteral("report.copy"));
    m_copy->setToolTip(tr("Copies the command line that makes the picked method's map"));
    m_copy->setEnabled(false);
    m_use->setObjectName(QStringLiteral("report.use"));
    m_use->setToolTip(tr("Filters the scene by this method though it takes long"));
    m_use->hide();
    for (QPushButton* button : {m_again, m_stop, m_copy, m_use})
        button->setAccessibleName(button->text().remove(u'&'));

    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_copy);
    buttons->addWidget(m_use);
    buttons->addStretch(1);
    buttons->addWidget(m_stop);
    buttons->addWidget(m_again);
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 4, 0);
    column->setSpacing(6);
    column->addWidget(m_status);
    column->addWidget(m_progress);
    column->addWidget(makeForm());
    column->addWidget(m_facts);
    column->addLayout(buttons);
    column->addStretch(1);
    QScrollArea* scroll = scrolled(side);
    scroll->setMinimumWidth(std::max(216, side->minimumSizeHint().width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent) + 2));
    scroll->setMinimumHeight(90);
    return scroll;
}

OptionsForm* ReportPanel::makeForm()
{
    auto* form = new OptionsForm(m_workspace.document);
    FieldStyles styles{{"tolerance", {.isHidden = true}},
                       {"mip_filtering", {.label = tr("Mip filtering")}},
                       {"paraboloid", {.label = tr("Kernels")}},
                       {"paraboloid_clamp", {.label = tr("Clamp")}},
                       {"paraboloid_kernel", {.label = tr("Largest kernel")}},
                       {"paraboloid_half", {.label = tr("Half")}},
                       {"paraboloid_border", {.label = tr("Border")}}};
    for (const Method method : allMethods)
        for (const std::string_view knob : knobsOf(method))
            if (!fieldNamed<FilterSettings>(knob).name.empty()) // a scene's lambda is the material's
                styles[std::string(knob)].isShown = [knob](const Scene& scene) { return hasKnob(scene.filter.method, knob); };
    form->addFields(
        "filter", [](auto& scene) -> auto& { return scene.filter; }, styles);
    addTolerance(*form);
    return form;
}

/// A list of decades: what a slider of such small numbers would be moved to anyway.
void ReportPanel::addTolerance(OptionsForm& form)
{
    auto* tolerance = new QComboBox;
    tolerance->setObjectName(QStringLiteral("filter.tolerance"));
    tolerance->setAccessibleName(tr("Tolerance"));
    tolerance->setToolTip(tr("Largest error of the map, rel_rms, that spectral, direct and hierarchical keep and auto plans for"));
    for (const double value : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
        tolerance->addItem(toQString(shortNumber(value)), value);
    form.layout()->addRow(tr("Tolerance"), tolerance);
    const auto show = [this, tolerance] {
        const double value = m_workspace.document.scene().filter.tolerance;
        int index = tolerance->findData(value);
        if (index < 0) { // of a file that was written by hand
            tolerance->addItem(toQString(shortNumber(value)), value);
            index = tolerance->count() - 1;
        }
        tolerance->setCurrentIndex(index);
    };
    show();
    connect(&m_workspace.document, &Document::changed, tolerance, show);
    connect(tolerance, &QComboBox::activated, this, [this, tolerance] {
        const double value = tolerance->currentData().toDouble();
        m_workspace.document.edit(tr("Tolerance of the filter"), {}, [value](Scene& scene) { scene.filter.tolerance = value; });
    });
}

QString ReportPanel::waitingText() { return tr("Methods are measured once the material has come to rest."); }

void ReportPanel::resizeEvent(QResizeEvent*)
{
    // A low dock, as beside the plan, has no height to share among three.
    const bool isLow = width() > 480 && 2 * width() > 3 * height();
    const Qt::Orientation orientation = width() > 640 || isLow ? Qt::Horizontal : Qt::Vertical;
    if (orientation == m_splitter->orientation() && m_isArranged)
        return;
    m_isArranged = true;
    m_splitter->setOrientation(orientation);
    constexpr int table = 290; // method, time and error are seen without scrolling
    const int side = m_splitter->widget(2)->minimumWidth();
    m_splitter->setSizes(orientation == Qt::Horizontal ? QList<int>{width() - table - side, table, side} : QList<int>{300, 200, 170});
}

void ReportPanel::showEvent(QShowEvent*) { follow(); }

/// Measures when the scene has come to rest and its lobe or probe is another one; never while nobody looks.
void ReportPanel::follow()
{
    if (!isVisible())
        return;
    const bool hasPoints = m_isMeasuring || !m_points.empty() || m_race;
    if (m_gaveWay || !hasPoints || measurementOf(m_measured) != measurementOf(m_workspace.document.scene()))
        m_rest.start();
}

/// What an edit wants of the processor comes first; and what is measured beside it would be measured wrongly.
void ReportPanel::giveWay()
{
    m_rest.stop();
    if (!m_isMeasuring || m_gaveWay)
        return;
    m_gaveWay = true;
    m_runner.stop();
    m_status->setText(waitingText());
}

void ReportPanel::goOn()
{
    if (!isVisible() || !m_workspace.live.isUpToDate() || m_workspace.document.isDragging())
        return; // the end of the drag, the new maps or the panel's showing call again
    const bool waited = std::exchange(m_gaveWay, false);
    if (measurementOf(m_measured) != measurementOf(m_workspace.document.scene()) || (!m_isMeasuring && m_points.empty() && !m_race))
        start();
    else if (waited && m_race)
        measureNext(m_next);
    else if (waited)
        start();
}

void ReportPanel::measure() { start(); }

void ReportPanel::stop()
{
    if (!m_isMeasuring)
        return;
    m_runner.stop();
    finish(tr("Stopped after %1 points.").arg(m_points.size()));
}

void ReportPanel::finish(const QString& status)
{
    m_isMeasuring = m_gaveWay = false;
    m_progress->hide();
    m_stop->hide();
    m_again->show();
    m_status->setText(status);
}

void ReportPanel::start()
{
    const auto made = m_workspace.live.made();
    m_rest.stop();
    m_gaveWay = false;
    m_measured = m_workspace.document.scene();
    m_points.clear();
    m_race.reset();
    m_picked = -1;
    m_table->clear();
    m_chart->setPoints({});
    m_facts->clear();
    m_copy->setEnabled(false);
    m_use->hide();
    m_workspace.methodError.clear();
    const Lobe lobe = mirrorball::lobe(m_measured.material.specular);
    if (lobe.isMirror())
        return finish(tr("The material is a mirror: its map is the environment itself, and no method filters it. Choose Phong or GGX to "
                         "compare methods."));
    if (!made || !made->environment)
        return finish(tr("There is no probe in memory to measure with."));
    m_isMeasuring = true;
    m_again->hide();
    m_stop->show();
    m_progress->setRange(0, 0);
    m_progress->show();
    const MapLayout target{m_measured.map.parameterization, std::min(m_measured.map.size, measuredSize), 0};
    m_status->setText(tr("Summing the reference for %1 ...").arg(toQString(mirrorball::describe(lobe))));
    m_runner.start(
        [environment = made->environment, lobe, target](const JobControl& job) {
            return std::make_shared<MethodRace>(FilterSource(*environment, job), lobe, MethodRaceOptions{.target = target}, job);
        },
        [this](std::shared_ptr<MethodRace> race) {
            m_race = std::move(race);
            m_progress->setRange(0, static_cast<int>(m_race->settings().size()));
            add(m_race->reference());
            measureNext(0);
        });
}

void ReportPanel::measureNext(size_t setting)
{
    m_next = setting;
    m_progress->setValue(static_cast<int>(setting));
    if (setting >= m_race->settings().size()) {
        const auto measured =
            std::count_if(m_points.begin(), m_points.end(), [](const RacePoint& p) { return p.state == MeasurementState::Measured; });
        const MapLayout& target = m_race->options().target;
        finish(tr("%1 into a %2 of size %3: %4 settings measured.")
                   .arg(toQString(mirrorball::describe(m_race->lobe())), fieldText(name(target.kind)))
                   .arg(target.size)
                   .arg(measured));
        return;
    }
    m_status->setText(tr("Measuring %1 ... (about %2 for all settings)")
                          .arg(toQString(name(m_race->settings()[setting].method)), toQString(durationText(m_race->expectedSeconds()))));
    m_runner.start([race = m_race, setting](const JobControl& job) { return race->measure(race->settings()[setting], job); },
                   [this, setting](const RacePoint& point) {
                       add(point);
                       measureNext(setting + 1);
                   });
}

void ReportPanel::add(const RacePoint& point)
{
    m_points.push_back(point);
    m_table->add(point);
    m_chart->setPoints(m_points);
}

QString ReportPanel::describe(const RacePoint& point) const
{
    const QString label = point.setting.label.empty() ? QString() : QStringLiteral(", ") + toQString(point.setting.label);
    QString text = fieldText(name(point.setting.method)) + label;
    if (point.setting.method == Method::Auto && point.state == MeasurementState::Measured)
        text += tr(" (ran %1)").arg(fieldText(name(point.ran)));
    return text;
}

/// What the scene's own map would take by a setting.
double ReportPanel::secondsAtFullSize(const RacePoint& point) const
{
    const MapSettings& map = m_workspace.document.scene().map;
    const PrefilterOptions options = point.setting.options(m_race->lobe(), {map.parameterization, map.size, map.border});
    const auto made = m_workspace.live.made();
    const ProbeTraits probe{.width = made ? 2 * latlongHeight(made->probeLayout) : 1024};
    return refusal(options.method, options, probe).empty() ? planPrefilter(options, probe).predictedSeconds : 0.0;
}

void ReportPanel::copyCommand()
{
    const RacePoint& point = m_points[static_cast<size_t>(m_picked)];
    const QString probe = QString::fromStdString(resolved(m_measured, m_measured.probe.source));
    QGuiApplication::clipboard()->setText(
        QString::fromStdString(filterCommand(probe.toStdString(), point.setting.options(m_race->lobe(), m_race->options().target))));
}

void ReportPanel::use()
{
    const MethodSetting& setting = m_points[static_cast<size_t>(m_picked)].setting;
    m_use->hide();
    m_workspace.document.edit(tr("Filtering method"), {}, [&](Scene& scene) {
        scene.filter.method = setting.method;
        scene.filter.tolerance = setting.tolerance;
        scene.filter.samples = setting.knobs.samples;
        scene.filter.mipFiltering = setting.knobs.mipFiltering;
        scene.filter.paraboloid = setting.knobs.paraboloid;
    });
}

void ReportPanel::pick(int index)
{
    if (index < 0 || index >= static_cast<int>(m_points.size()) || index == m_picked)
        return;
    m_picked = index;
    showPicked();
    const RacePoint& point = m_points[static_cast<size_t>(index)];
    m_workspace.methodError.clear();
    m_use->hide();
    if (point.state != MeasurementState::Measured)
        return;
    if (const double seconds = secondsAtFullSize(point); seconds > longWait) {
        m_facts->setText(m_facts->text() + tr(" At the size of the scene's map it takes about %1.").arg(secondsText(seconds)));
        m_use->show();
    } else {
        use();
    }
    if (!point.map)
        return;
    const QString text = tr("%1: method minus reference, rel_rms %2").arg(describe(point), shortNumberText(point.error.relRms));
    m_errorRunner.start(
        [environment = m_workspace.live.made()->environment, lobe = m_race->lobe(), map = point.map](const JobControl& job) {
            return std::make_shared<const EnvironmentMap>(signedError(FilterSource(*environment, job), lobe, *map, job));
        },
        [this, text](const std::shared_ptr<const EnvironmentMap>& error) { m_workspace.methodError.show(error, text); });
}

void ReportPanel::showPicked()
{
    const RacePoint& point = m_points[static_cast<size_t>(m_picked)];
    m_chart->setPicked(m_picked);
    m_table->setPicked(m_picked);
    QString text = describe(point) + QStringLiteral(": ");
    if (point.state != MeasurementState::Measured)
        text += toQString(point.why);
    else if (point.setting.method == Method::Reference)
        text += tr("%1 for the whole map, by which the others are judged").arg(secondsText(point.seconds));
    else
        text += tr("%1 (predicted %2), rel_rms %3 (predicted %4), largest %5 × rms. Its signed error is in the Map panel.")
                    .arg(secondsText(point.seconds), secondsText(point.predictedSeconds), shortNumberText(point.error.relRms),
                         shortNumberText(point.predictedError), shortNumberText(point.error.maxAbs));
    m_facts->setText(text);
    m_copy->setEnabled(point.state == MeasurementState::Measured);
}

} // namespace mirrorball::studio
