#include "probe_details.h"

#include "widgets/controls/color_scale_bar.h"
#include "widgets/controls/keep_place.h"
#include "widgets/controls/text.h"

#include "core/base/error.h"
#include "core/image/color_space.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirrorball::studio {

namespace {

/// What of a reading the facts of a file depend on.
ProbeReading withoutTurn(ProbeReading reading)
{
    reading.mirror = MirrorAxis::None;
    reading.rotateDeg = glm::dvec3(0.0);
    return reading;
}

QString rangeText(const ProbeStatistics& s)
{
    QString text = ProbeDetails::tr("%1 to %2").arg(shortNumberText(s.minLuminance), shortNumberText(s.maxLuminance));
    if (s.minLuminance > 0.0 && s.maxLuminance > s.minLuminance)
        text += ProbeDetails::tr(" (%1 stops)").arg(std::log2(s.maxLuminance / s.minLuminance), 0, 'f', 1);
    return text;
}

/// What a survey found, and what was assumed, each with its label.
std::vector<std::pair<QString, QString>> facts(const ProbeSurvey& survey)
{
    const ReducedProbe& probe = survey.reduced;
    const ProbeStatistics& s = survey.statistics;
    std::vector<std::pair<QString, QString>> rows{
        {ProbeDetails::tr("size"), QStringLiteral("%1 × %2").arg(probe.info.width).arg(probe.info.height)},
        {ProbeDetails::tr("kind"),
         QStringLiteral("%1: %2").arg(fieldText(name(probe.detection.layout.kind)), toQString(probe.detection.reason))},
        {ProbeDetails::tr("luminance"), rangeText(s)},
        {ProbeDetails::tr("mean"), shortNumberText(s.meanLuminance)},
        {ProbeDetails::tr("sun"), ProbeDetails::tr("the brightest 0.01 % hold %1 % of the energy").arg(100.0 * s.sunShare, 0, 'f', 1)},
        {ProbeDetails::tr("texels"), toQString(describe(probe.repaired))}};
    for (const Assumption& a : allAssumed(probe.info, probe.detection))
        if (a.topic != "parameterization" && (a.certainty != Certainty::Certain || !a.others.empty()))
            rows.push_back({toQString(a.topic), toQString(a.value)});
    for (const std::string& note : allNotes(probe.info, probe.detection))
        rows.push_back({ProbeDetails::tr("note"), toQString(note)});
    if (s.beyondHalf > 0)
        rows.push_back({ProbeDetails::tr("half float"), s.beyondHalf == 1 ? ProbeDetails::tr("1 value beyond 65504")
                                                                          : ProbeDetails::tr("%1 values beyond 65504").arg(s.beyondHalf)});
    return rows;
}

/// Facts as rows of a table: rich text, so that labels and values align and values can be copied.
QString table(const std::vector<std::pair<QString, QString>>& rows)
{
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='1'>");
    for (const auto& [label, value] : rows)
        html += QStringLiteral("<tr><td style='color:#9a9a9a; padding-right:10px'>%1</td><td>%2</td></tr>")
                    .arg(label.toHtmlEscaped(), value.toHtmlEscaped());
    return html + QStringLiteral("</table>");
}

} // namespace

ProbeDetails::ProbeDetails(Workspace& workspace, const ProbeWatcher& watcher, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_watcher(watcher), m_survey(this), m_name(new QLabel), m_facts(new QLabel),
      m_guessText(new QLabel), m_guesses(new QWidget), m_readAs(new QComboBox), m_progress(new QProgressBar)
{
    makeFacts();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 4, 0);
    layout->setSpacing(6);
    layout->addWidget(m_name);
    layout->addWidget(m_guessText);
    layout->addWidget(m_guesses);
    layout->addWidget(m_facts);
    layout->addWidget(m_progress);
    layout->addWidget(makeForm());
    layout->addStretch(1);

    connect(&m_watcher, &ProbeWatcher::sourceChanged, this, [this] {
        m_kinds.clear();
        m_isCertain = true;
        survey();
    });
    connect(&m_watcher, &ProbeWatcher::fileChanged, this, &ProbeDetails::survey);
    connect(&m_workspace.document, &Document::changed, this, [this](Parts parts) {
        if (!parts.testFlag(Part::Probe))
            return;
        if (withoutTurn(m_workspace.document.scene().probe.reading) != m_reading)
            survey();
        else
            readScene();
    });
    connect(&m_survey, &JobRunner::failed, this, &ProbeDetails::showProblem);
    connect(&m_survey, &JobRunner::progressed, this, [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&m_survey, &JobRunner::busyChanged, this, [this](bool busy) { m_progress->setVisible(busy); });
    survey();
}

void ProbeDetails::makeFacts()
{
    QFont bold = m_name->font();
    bold.setBold(true);
    m_name->setFont(bold);
    m_name->setTextFormat(Qt::PlainText);
    m_name->setWordWrap(true);
    m_name->setObjectName(QStringLiteral("probes.name"));
    m_facts->setObjectName(QStringLiteral("probes.facts"));
    m_facts->setAccessibleName(tr("Facts of the probe"));
    m_facts->setWordWrap(true);
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    makeSlim(*m_progress);
    m_progress->setAccessibleName(tr("Reading the probe"));
    m_guessText->setWordWrap(true);
    m_guesses->setObjectName(QStringLiteral("probes.guesses"));
    auto* guesses = new QHBoxLayout(m_guesses);
    guesses->setContentsMargins(0, 0, 0, 0);
    guesses->setSpacing(4);
}

OptionsForm* ProbeDetails::makeForm()
{
    m_readAs->setObjectName(QStringLiteral("probes.read_as"));
    m_readAs->setAccessibleName(tr("Read as"));
    m_readAs->setToolTip(tr("How the file shows the sphere"));
    connect(m_readAs, &QComboBox::activated, this, [this] {
        const int kind = m_readAs->currentData().toInt();
        readAs(kind < 0 ? std::nullopt : std::optional(static_cast<Parameterization>(kind)));
    });
    auto* form = new OptionsForm(m_workspace.document);
    form->layout()->addRow(tr("Read as"), m_readAs);
    QStringList colorSpaces;
    for (const std::string& name : colorSpaceNames())
        colorSpaces << QString::fromStdString(name);
    form->addFields("probe", [](auto& scene) -> auto& { return scene.probe; },
                    {{"source", {.isHidden = true}},
                     {"parameterization", {.isHidden = true}},
                     {"yaw", {.label = tr("Turn"), .sliderLow = -180.0, .sliderHigh = 180.0, .step = 1.0}},
                     {"exposure", {.label = tr("Brightness"), .sliderLow = -10.0, .sliderHigh = 10.0, .step = 0.25}},
                     {"part", {.isText = true}},
                     {"layer", {.isText = true}},
                     {"color_space", {.isText = true, .suggestions = colorSpaces}},
                     {"faces", {.isText = true}},
                     {"horizontal_angle", {.step = 1.0}},
                     {"vertical_angle", {.step = 1.0}}});
    return form;
}

void ProbeDetails::survey()
{
    m_reading = withoutTurn(m_workspace.document.scene().probe.reading);
    readScene();
    m_facts->setText(tr("Reading ..."));
    m_survey.start(
        [source = m_watcher.source(), reading = m_workspace.document.scene().probe.reading](const JobControl& job) {
            const bool isBuiltin = source.startsWith(QStringLiteral("builtin:"));
            ProbeSurvey survey =
                surveyProbe(isBuiltin ? source.toStdString() : toPath(source).string(), {.height = 96, .reading = reading}, job);
            std::vector<ProbeGuess> guesses;
            ReducedProbe& reduced = survey.reduced;
            // Whether the file alone says what it is: a choice that was made must stay open.
            if (reading.parameterization && !isBuiltin)
                try {
                    reduced.detection.certain = detectLayout(reduced.info).certain;
                } catch (const Error&) {
                    reduced.detection.certain = true;
                }
            if (!reduced.detection.certain) {
                const double mean = survey.statistics.meanLuminance;
                guesses = probeGuesses(reduced, mean > 0.0 ? std::log2(0.25 / mean) : 0.0, job);
            }
            return std::pair(std::move(survey), std::move(guesses));
        },
        [this](const auto& result) { showSurvey(result.first, result.second); });
}

void ProbeDetails::showSurvey(const ProbeSurvey& survey, const std::vector<ProbeGuess>& guessed)
{
    const ReducedProbe& probe = survey.reduced;
    m_kinds = possibleKinds(probe);
    std::sort(m_kinds.begin(), m_kinds.end());
    m_isCertain = probe.detection.certain;
    m_facts->setText(table(facts(survey)));
    m_guessText->setText(m_isCertain ? QString()
                                     : tr("The shape fits several kinds. The right one has a level horizon and straight verticals:"));
    m_guessText->setVisible(!m_isCertain);
    showGuesses(guessed);
    readScene();
    const bool isBall = probe.detection.arrangement == Arrangement::Ball;
    for (QToolButton* button : guesses())
        button->setChecked(
            button->objectName().endsWith(u'.' + (isBall ? QStringLiteral("ball") : toQString(name(probe.detection.layout.kind)))));
}

void ProbeDetails::showGuesses(const std::vector<ProbeGuess>& guessed)
{
    qDeleteAll(m_guesses->findChildren<QToolButton*>());
    for (const ProbeGuess& guess : guessed) {
        const bool isBall = guess.fit == Fit::Crop;
        const QString word = guessText(guess);
        auto* button = new QToolButton(m_guesses);
        button->setObjectName(QStringLiteral("probes.guess.") + (isBall ? QStringLiteral("ball") : toQString(name(guess.kind))));
        button->setCheckable(true);
        button->setText(word);
        button->setAccessibleName(tr("Read as %1").arg(word));
        button->setToolTip(isBall ? tr("Finds a mirror ball in the photograph and reads it as a sphere map")
                                  : tr("Reads the file as this kind of map"));
        button->setIcon(QIcon(QPixmap::fromImage(guess.picture)));
        button->setIconSize({80, 40});
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this, [this, kind = guess.kind, fit = guess.fit] { readAs(kind, fit); });
        m_guesses->layout()->addWidget(button);
    }
    m_guesses->setVisible(!guessed.empty());
}

void ProbeDetails::showProblem(const QString& message)
{
    m_kinds.assign(allParameterizations.begin(), allParameterizations.end()); // with a fit it may be any
    m_guessText->hide();
    m_guesses->hide();
    m_facts->setText(QStringLiteral("<span style='color:#e07a5f'>%1</span>").arg(message.toHtmlEscaped()));
    readScene();
}

QList<QToolButton*> ProbeDetails::guesses() const { return m_guesses->findChildren<QToolButton*>(); }

void ProbeDetails::readAs(std::optional<Parameterization> kind, std::optional<Fit> fit)
{
    m_workspace.document.edit(tr("Read probe as"), {}, [&](Scene& scene) {
        scene.probe.reading.parameterization = kind;
        if (fit)
            scene.probe.reading.fit = *fit;
    });
}

void ProbeDetails::readScene()
{
    const QString& source = m_watcher.source();
    const bool isBuiltin = source.startsWith(QStringLiteral("builtin:"));
    m_name->setText(isBuiltin ? tr("%1 (built in)").arg(source.mid(8)) : QFileInfo(source).fileName());
    m_name->setToolTip(isBuiltin ? QString() : QDir::toNativeSeparators(source));
    const auto& chosen = m_workspace.document.scene().probe.reading.parameterization;
    const QSignalBlocker blocker(m_readAs);
    m_readAs->clear();
    m_readAs->addItem(tr("Automatic"), -1);
    std::vector<Parameterization> kinds = m_kinds;
    if (chosen && std::find(kinds.begin(), kinds.end(), *chosen) == kinds.end())
        kinds.push_back(*chosen);
    for (const Parameterization kind : kinds)
        m_readAs->addItem(labelText(name(kind)), static_cast<int>(kind));
    m_readAs->setCurrentIndex(std::max(0, m_readAs->findData(chosen ? static_cast<int>(*chosen) : -1)));
    m_readAs->setEnabled(!isBuiltin && !kinds.empty());
    const bool isBall = m_workspace.document.scene().probe.reading.fit == Fit::Crop;
    for (QToolButton* button : guesses())
        if (chosen)
            button->setChecked(button->objectName().endsWith(u'.' + (isBall ? QStringLiteral("ball") : toQString(name(*chosen)))));
}

} // namespace mirrorball::studio
