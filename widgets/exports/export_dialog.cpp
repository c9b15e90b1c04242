#include "export_dialog.h"

#include "export_words.h"
#include "widgets/controls/disconnect_children.h"
#include "widgets/controls/keep_place.h"
#include "widgets/controls/text.h"

#include "core/scene/export_command.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QSettings>
#include <QSignalBlocker>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace mirrorball::studio {

ExportDialog::ExportDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent), m_workspace(workspace), m_runner(this), m_estimator(this), m_card(new EngineCard),
      m_list(new ExportList(workspace.document)), m_form(new ExportForm), m_place(new ExportPlace)
{
    setWindowTitle(tr("Export maps"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(10);
    layout->addLayout(makeTop(), 1);
    m_total = new QLabel;
    m_total->setObjectName(QStringLiteral("export.total"));
    m_total->setAccessibleName(tr("Estimate"));
    layout->addWidget(m_total);
    layout->addWidget(m_place);
    m_progress = new QProgressBar;
    m_progress->setObjectName(QStringLiteral("export.progress"));
    m_progress->setAccessibleName(tr("Progress of the export"));
    m_progress->setRange(0, 1000);
    makeSlim(*m_progress, 6);
    layout->addWidget(m_progress);
    layout->addLayout(makeBottom());
    m_open->hide();
    setExporting(false);
    followParts();
    followJobs();
    followDocument();

    const QString scene = workspace.document.filePath();
    const QString beside = scene.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation) + QStringLiteral("/maps")
                                           : QFileInfo(scene).absolutePath() + QStringLiteral("/maps");
    resize(sizeHint());
    setMinimumSize(940, 560);
    setFolder(QSettings().value(QStringLiteral("export/folder"), beside).toString());
    offerPainted();
    m_list->readScene();
    m_list->selectRow(0);
    const QString last = QSettings().value(QStringLiteral("export/engine"), QStringLiteral("three")).toString();
    chooseEngine(workspace.document.scene().exports.empty() ? last : QString());
}

ExportDialog::~ExportDialog() { disconnectChildren(*this); }

/// The gallery, beside it the scene's own list or the chosen engine's card.
QLayout* ExportDialog::makeTop()
{
    auto* own = new QWidget;
    auto* ownLayout = new QHBoxLayout(own);
    ownLayout->setContentsMargins(0, 0, 0, 0);
    ownLayout->setSpacing(12);
    ownLayout->addWidget(m_list, 3);
    ownLayout->addWidget(m_form, 2);
    m_pages = new QStackedWidget;
    m_pages->addWidget(own);
    m_pages->addWidget(m_card);
    auto* top = new QHBoxLayout;
    top->setSpacing(12);
    top->addWidget(makeGallery());
    top->addWidget(m_pages, 1);
    return top;
}

QLayout* ExportDialog::makeBottom()
{
    auto* bottom = new QHBoxLayout;
    m_status = new QLabel;
    m_status->setObjectName(QStringLiteral("export.status"));
    m_status->setAccessibleName(tr("State of the export"));
    m_status->setWordWrap(true);
    m_open = new QPushButton(tr("Show &folder"));
    m_open->setObjectName(QStringLiteral("export.open"));
    m_export = new QPushButton(tr("&Export"));
    m_export->setObjectName(QStringLiteral("export.start"));
    m_export->setDefault(true);
    m_cancel = new QPushButton(tr("&Cancel"));
    m_cancel->setObjectName(QStringLiteral("export.cancel"));
    m_close = new QPushButton(tr("C&lose"));
    m_close->setObjectName(QStringLiteral("export.close"));
    bottom->addWidget(m_status, 1);
    for (QPushButton* button : {m_open, m_cancel, m_close, m_export})
        bottom->addWidget(button);
    m_open->setToolTip(tr("Shows the written files in the file manager"));
    m_export->setToolTip(tr("Writes the maps that are checked"));
    m_cancel->setToolTip(tr("Stops; files that are not finished leave nothing behind"));
    m_close->setToolTip(tr("Closes this window"));
    return bottom;
}

void ExportDialog::followParts()
{
    connect(m_list, &ExportList::selectionShown, this, &ExportDialog::showTarget);
    connect(m_list, &ExportList::checksChanged, this, [this] {
        showEstimates(m_estimates);
        showCommand();
    });
    connect(m_list, &ExportList::added, this, [this] { chooseEngine({}); }); // who adds a map wants the scene's own list
    connect(m_form, &ExportForm::edited, this, &ExportDialog::change);
    connect(m_card, &EngineCard::sizeChanged, this, [this] {
        estimateEngine();
        showCommand();
    });
    connect(m_place, &ExportPlace::folderChanged, this, &ExportDialog::showCommand);
    connect(m_place, &ExportPlace::copied, this, [this] { say(tr("The command line is on the clipboard.")); });
    connect(m_place, &ExportPlace::saveRequested, this, &ExportDialog::saveRequested);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::startExport);
    connect(m_cancel, &QPushButton::clicked, this, &ExportDialog::cancelExport);
    connect(m_close, &QPushButton::clicked, this, &ExportDialog::reject);
    connect(m_open, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder())); });
}

void ExportDialog::followJobs()
{
    connect(&m_runner, &JobRunner::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(1000.0 * fraction)); });
    connect(&m_runner, &JobRunner::stopped, this, [this] {
        setExporting(false);
        say(tr("Cancelled. Maps that were finished are there, the others left nothing behind."));
    });
    connect(&m_runner, &JobRunner::failed, this, [this](const QString& message) {
        setExporting(false);
        say(message, true);
    });
    connect(&m_estimator, &JobRunner::failed, this, [this](const QString& message) {
        if (m_engine)
            m_card->showProblem(message);
        else
            showEstimates({});
        say(message, true);
    });
}

void ExportDialog::followDocument()
{
    Document& document = m_workspace.document;
    connect(&document, &Document::changed, this, [this](Parts parts) {
        if (parts.testFlag(Part::Exports))
            m_list->readScene();
        offerPainted();
        if (parts & (Parts(Part::Exports) | Part::Probe | Part::Material | Part::Folder))
            m_engine ? estimateEngine() : estimate();
        showCommand();
    });
    connect(&document, &Document::refused, this, [this](const QString& message) {
        say(message, true);
        showTarget();
    });
    connect(&document, &Document::modifiedChanged, this, &ExportDialog::showCommand);
    connect(&document, &Document::fileChanged, this, &ExportDialog::showCommand);
}

QWidget* ExportDialog::makeGallery()
{
    m_gallery = new QListWidget;
    m_gallery->setObjectName(QStringLiteral("export.gallery"));
    m_gallery->setAccessibleName(tr("What to export for"));
    m_gallery->setToolTip(tr("An engine gets the scene's light as it takes it; below them, the maps that the scene lists itself"));
    const auto add = [this](const QString& title, const QString& below, std::string_view word) {
        auto* item = new QListWidgetItem(title + QLatin1Char('\n') + below);
        item->setData(Qt::UserRole, toQString(word));
        item->setSizeHint({0, 2 * fontMetrics().height() + 12});
        m_gallery->addItem(item);
    };
    for (const EngineProfile& profile : engineProfiles())
        add(toQString(profile.title), profile.proven.empty() ? tr("not proven") : provenText(profile), profile.word);
    add(tr("Maps of the scene"), tr("chosen one by one"), {});
    m_gallery->setFixedWidth(190);
    connect(m_gallery, &QListWidget::currentItemChanged, this,
            [this](const QListWidgetItem* item) { chooseEngine(item ? item->data(Qt::UserRole).toString() : QString()); });
    return m_gallery;
}

void ExportDialog::chooseEngine(const QString& word)
{
    const auto profiles = engineProfiles();
    const auto found = std::find_if(profiles.begin(), profiles.end(), [&](const EngineProfile& p) { return toQString(p.word) == word; });
    m_engine = found == profiles.end() ? nullptr : &*found;
    {
        const QSignalBlocker blocker(m_gallery);
        m_gallery->setCurrentRow(static_cast<int>(found - profiles.begin())); // the scene's own list stands last
    }
    m_pages->setCurrentIndex(m_engine ? 1 : 0);
    say({});
    m_estimator.stop();
    if (m_engine) {
        QSettings().setValue(QStringLiteral("export/engine"), word);
        m_card->show(*m_engine);
        estimateEngine();
    } else {
        estimate();
    }
    showCommand();
}

void ExportDialog::estimateEngine()
{
    m_total->setText(tr("No estimate yet."));
    m_export->setEnabled(canExport());
    const EngineExportOptions options{.size = m_card->size(), .name = engineExportName(toPath(folder()))};
    m_estimator.start([scene = m_workspace.document.scene(), profile = *m_engine,
                       options](const JobControl& job) { return estimateForEngine(scene, profile, options, job); },
                      [this](const EngineEstimate& estimate) {
                          m_card->showEstimate(estimate);
                          m_total->setText(
                              tr("%1, about %2 in all").arg(filesText(estimate.files.size()), toQString(byteText(estimate.bytes))));
                      });
}

/// The same bytes as the command line's.
void ExportDialog::exportEngine()
{
    setExporting(true);
    say(tr("Exporting ..."));
    const EngineExportOptions options{.size = m_card->size(), .name = engineExportName(toPath(folder()))};
    m_runner.start([scene = m_workspace.document.scene(), profile = *m_engine, options,
                    folder = toPath(folder())](const JobControl& job) { return exportForEngine(scene, profile, options, folder, job); },
                   [this](const EngineExport& done) { finish(done.files); });
}

bool ExportDialog::canExport() const { return !m_isExporting && (m_engine || !m_list->checkedNames().empty()); }

/// A sphere map can be written where the scene has one.
void ExportDialog::offerPainted()
{
    const bool hasMap = !m_workspace.document.scene().material.sphereMap.isNone();
    m_list->offerPainted(hasMap);
    m_form->offerPainted(hasMap);
}

void ExportDialog::change(const QString& label, const std::function<void(ExportTarget&)>& change)
{
    const int row = m_list->selectedRow();
    if (!m_list->selected())
        return;
    say({});
    m_workspace.document.edit(label, {}, [&](Scene& scene) { change(scene.exports[static_cast<size_t>(row)]); });
}

void ExportDialog::showTarget()
{
    m_form->showTarget(m_list->selected());
    showEstimates(m_estimates);
}

void ExportDialog::estimate()
{
    if (m_workspace.document.scene().exports.empty()) {
        m_estimator.stop();
        showEstimates({});
        return;
    }
    m_estimator.start(
        [scene = m_workspace.document.scene()](const JobControl&) {
            const PlanRequest request{.picture = false, .exports = std::vector<std::string>{}};
            const Plan plan = makePlan(scene, probeLayout(scene, request), request);
            return std::pair(estimateExports(plan), plan.sharedSeconds);
        },
        [this](const std::pair<std::vector<ExportEstimate>, double>& made) {
            m_sharedSeconds = made.second;
            showEstimates(made.first);
        });
}

void ExportDialog::showEstimates(const std::vector<ExportEstimate>& estimates)
{
    m_estimates = estimates;
    m_list->showEstimates(m_estimates);
    const ExportTarget* target = m_list->selected();
    const auto found =
        std::find_if(m_estimates.begin(), m_estimates.end(), [&](const ExportEstimate& e) { return target && e.name == target->name; });
    m_form->showEstimate(found == m_estimates.end() ? QString() : mapText(*found));
    m_total->setText(m_workspace.document.scene().exports.empty() ? tr("The scene exports nothing yet. Add a map to begin.")
                                                                  : totalText(m_estimates, m_list->checkedNames(), m_sharedSeconds));
    m_export->setEnabled(canExport());
}

void ExportDialog::showCommand()
{
    const Document& document = m_workspace.document;
    const std::vector<std::string> names = m_list->checkedNames();
    const bool isAll = names.size() == document.scene().exports.size();
    const bool isSaved = !document.filePath().isEmpty() && !document.isModified();
    const QString scene = document.filePath().isEmpty() ? QStringLiteral("SCENE.mirrorball") : document.filePath();
    const std::string command = m_engine ? engineExportCommand(toPath(scene), toPath(folder()), m_engine->word, m_card->size())
                                         : exportCommand(toPath(scene), toPath(folder()), isAll ? std::vector<std::string>{} : names);
    m_place->showCommand(QString::fromStdString(command), isSaved ? ExportPlace::SceneFile::UpToDate : ExportPlace::SceneFile::Older,
                         m_engine || !names.empty());
}

void ExportDialog::startExport()
{
    if (m_isExporting)
        return;
    if (folder().isEmpty()) {
        say(tr("Name the folder that the files go to."), true);
        m_place->focusFolder();
        return;
    }
    const std::vector<std::string> names = m_list->checkedNames();
    if (!m_engine && names.empty()) {
        say(tr("No map is checked."), true);
        return;
    }
    QSettings().setValue(QStringLiteral("export/folder"), folder());
    if (m_engine) {
        exportEngine();
        return;
    }
    setExporting(true);
    say(tr("Exporting ..."));
    const bool isAll = names.size() == m_workspace.document.scene().exports.size();
    m_runner.start([scene = m_workspace.document.scene(), folder = toPath(folder()), names = isAll ? std::vector<std::string>{} : names](
                       const JobControl& job) { return exportScene(scene, folder, {.only = names}, job); },
                   [this](const ExportOutcome& outcome) { finish(outcome.files); });
}

void ExportDialog::finish(const std::vector<std::filesystem::path>& written)
{
    setExporting(false);
    QStringList files;
    std::uintmax_t bytes = 0;
    for (const std::filesystem::path& file : written) {
        files << fromPath(file);
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(file, error);
        bytes += error ? 0 : size;
    }
    say(tr("Wrote %1, %2.").arg(filesText(static_cast<size_t>(files.size())), toQString(byteText(static_cast<std::int64_t>(bytes)))));
    m_open->show();
    emit exported(files);
}

void ExportDialog::cancelExport() { m_runner.stop(); }

void ExportDialog::reject()
{
    if (m_isExporting) { // Escape stops the work first; the window closes with the next one
        cancelExport();
        return;
    }
    QDialog::reject();
}

void ExportDialog::setExporting(bool exporting)
{
    m_isExporting = exporting;
    m_progress->setVisible(exporting);
    m_progress->setValue(0);
    m_cancel->setVisible(exporting);
    m_close->setVisible(!exporting);
    m_export->setEnabled(canExport());
    if (exporting)
        m_open->hide();
}

void ExportDialog::say(const QString& message, bool isProblem)
{
    m_status->setText(message);
    QPalette colors = palette();
    if (isProblem)
        colors.setColor(QPalette::WindowText, QColor(0xe0, 0x7a, 0x5f));
    m_status->setPalette(colors);
}

} // namespace mirrorball::studio
