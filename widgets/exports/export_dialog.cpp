#include "export_dialog.h"

#include "widgets/controls/disconnect_children.h"
#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/keep_place.h"
#include "widgets/controls/text.h"

#include "core/image/image_format.h"
#include "core/scene/export_command.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QSettings>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace mirrorball::studio {

namespace {

enum Column { NameColumn, KindColumn, LayoutColumn, SizeColumn };

QString kindText(ExportKind kind)
{
    switch (kind) {
    case ExportKind::Source:
        return ExportDialog::tr("Environment as it is");
    case ExportKind::Specular:
        return ExportDialog::tr("Specular, the material's lobe");
    case ExportKind::Diffuse:
        return ExportDialog::tr("Diffuse irradiance");
    case ExportKind::Chain:
        return ExportDialog::tr("Roughness chain, ggx 0 to 1");
    case ExportKind::Painted:
        return ExportDialog::tr("Sphere map, as it is painted");
    }
    return {};
}

constexpr std::array allKinds{ExportKind::Source, ExportKind::Specular, ExportKind::Diffuse, ExportKind::Chain, ExportKind::Painted};

/// Sizes step by doubling and halving.
class SizeBox : public QSpinBox {
public:
    using QSpinBox::QSpinBox;
    void stepBy(int steps) override
    {
        int size = value();
        for (int i = 0; i < std::abs(steps); ++i)
            size = steps > 0 ? size * 2 : std::max(1, size / 2);
        setValue(std::min(size, maximum()));
    }
};

QString filesText(size_t count) { return count == 1 ? ExportDialog::tr("1 file") : ExportDialog::tr("%1 files").arg(count); }

QLabel* quietLabel()
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setProperty("role", QStringLiteral("footnote"));
    return label;
}

} // namespace

ExportDialog::ExportDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent), m_workspace(workspace), m_runner(this), m_estimator(this)
{
    setWindowTitle(tr("Export maps"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(10);
    auto* own = new QWidget;
    auto* ownLayout = new QHBoxLayout(own);
    ownLayout->setContentsMargins(0, 0, 0, 0);
    ownLayout->setSpacing(12);
    ownLayout->addWidget(makeList(), 3);
    ownLayout->addWidget(makeForm(), 2);
    m_card = new EngineCard;
    m_pages = new QStackedWidget;
    m_pages->addWidget(own);
    m_pages->addWidget(m_card);
    auto* top = new QHBoxLayout;
    top->setSpacing(12);
    top->addWidget(makeGallery());
    top->addWidget(m_pages, 1);
    layout->addLayout(top, 1);
    m_total = new QLabel;
    m_total->setObjectName(QStringLiteral("export.total"));
    m_total->setAccessibleName(tr("Estimate"));
    layout->addWidget(m_total);
    layout->addWidget(makeFolderRow());

    m_progress = new QProgressBar;
    m_progress->setObjectName(QStringLiteral("export.progress"));
    m_progress->setAccessibleName(tr("Progress of the export"));
    m_progress->setRange(0, 1000);
    makeSlim(*m_progress, 6);
    layout->addWidget(m_progress);
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
    layout->addLayout(bottom);
    m_open->setToolTip(tr("Shows the written files in the file manager"));
    m_export->setToolTip(tr("Writes the maps that are checked"));
    m_cancel->setToolTip(tr("Stops; files that are not finished leave nothing behind"));
    m_close->setToolTip(tr("Closes this window"));
    m_open->hide();
    setExporting(false);

    connect(m_export, &QPushButton::clicked, this, &ExportDialog::startExport);
    connect(m_cancel, &QPushButton::clicked, this, &ExportDialog::cancelExport);
    connect(m_close, &QPushButton::clicked, this, &ExportDialog::reject);
    connect(m_open, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder())); });
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
    Document& document = workspace.document;
    connect(&document, &Document::changed, this, [this](Parts parts) {
        if (parts.testFlag(Part::Exports))
            listTargets();
        offerKinds();
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

    const QString scene = document.filePath();
    const QString beside = scene.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation) + QStringLiteral("/maps")
                                           : QFileInfo(scene).absolutePath() + QStringLiteral("/maps");
    resize(sizeHint());
    setMinimumSize(940, 560);
    m_folder->setText(QDir::toNativeSeparators(QSettings().value(QStringLiteral("export/folder"), beside).toString()));
    offerKinds();
    listTargets();
    selectRow(0);
    const QString last = QSettings().value(QStringLiteral("export/engine"), QStringLiteral("three")).toString();
    chooseEngine(document.scene().exports.empty() ? last : QString());
}

ExportDialog::~ExportDialog() { disconnectChildren(*this); }

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
    connect(m_card, &EngineCard::sizeChanged, this, [this] {
        estimateEngine();
        showCommand();
    });
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

bool ExportDialog::canExport() const { return !m_isExporting && (m_engine || !checkedNames().empty()); }

QWidget* ExportDialog::makeList()
{
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    m_list = new QTreeWidget;
    m_list->setObjectName(QStringLiteral("export.list"));
    m_list->setAccessibleName(tr("Maps to export"));
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setColumnCount(4);
    m_list->setHeaderLabels({tr("Name"), tr("Map"), tr("Layout"), tr("Size")});
    m_list->headerItem()->setTextAlignment(SizeColumn, Qt::AlignRight | Qt::AlignVCenter);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(NameColumn, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(KindColumn, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(LayoutColumn, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(SizeColumn, QHeaderView::ResizeToContents);
    m_list->setMinimumWidth(400);
    auto* buttons = new QHBoxLayout;
    auto* add = new QPushButton(tr("&Add"));
    add->setObjectName(QStringLiteral("export.add"));
    add->setToolTip(tr("Adds a map to the list"));
    auto* menu = new QMenu(add);
    menu->setToolTipsVisible(true);
    for (const ExportKind kind : allKinds)
        m_addPainted = menu->addAction(kindText(kind), this, [this, kind] { addTarget(kind); }); // the last one
    add->setMenu(menu);
    m_duplicate = new QPushButton(tr("&Duplicate"));
    m_duplicate->setObjectName(QStringLiteral("export.duplicate"));
    m_duplicate->setToolTip(tr("Adds a copy of the selected map"));
    m_remove = new QPushButton(tr("&Remove"));
    m_remove->setObjectName(QStringLiteral("export.remove"));
    m_remove->setToolTip(tr("Takes the selected map off the list; files on disk stay"));
    for (QPushButton* button : {add, m_duplicate, m_remove}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    layout->addWidget(m_list, 1);
    layout->addLayout(buttons);
    connect(m_duplicate, &QPushButton::clicked, this, &ExportDialog::duplicateTarget);
    connect(m_remove, &QPushButton::clicked, this, &ExportDialog::removeTarget);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ExportDialog::showTarget);
    connect(m_list, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item) {
        const QString name = item->text(NameColumn);
        m_unchecked.removeAll(name);
        if (item->checkState(NameColumn) == Qt::Unchecked)
            m_unchecked << name;
        showEstimates(m_estimates);
        showCommand();
    });
    return box;
}

QWidget* ExportDialog::makeForm()
{
    m_form = new QWidget;
    m_form->setMinimumWidth(300);
    m_rows = new QFormLayout(m_form);
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_rows->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const auto add = [this](const QString& label, QWidget* control, const char* name, const QString& help) {
        control->setObjectName(QLatin1String(name));
        control->setToolTip(help);
        QString plain = label;
        control->setAccessibleName(plain.remove(u'&'));
        auto* text = new QLabel(label);
        text->setBuddy(control);
        m_rows->addRow(text, control);
    };
    m_name = new QLineEdit;
    m_kind = new QComboBox;
    m_parameterization = new QComboBox;
    m_size = new SizeBox;
    m_border = new QSpinBox;
    m_format = new QComboBox;
    m_faces = new QCheckBox(tr("six files, one a face"));
    m_mips = new QCheckBox(tr("coarser levels"));
    m_levelFiles = new QCheckBox(tr("one file a level"));
    m_levels = new QSpinBox;
    m_file = new QLineEdit;
    m_files = quietLabel();
    for (const ExportKind kind : allKinds)
        m_kind->addItem(kindText(kind), static_cast<int>(kind));
    for (const Parameterization kind : allParameterizations)
        m_parameterization->addItem(labelText(name(kind)), static_cast<int>(kind));
    for (const ExportFormat& format : exportFormats())
        m_format->addItem(format.text);
    m_size->setRange(1, 16384);
    m_size->setSuffix(tr(" texels"));
    m_border->setSuffix(tr(" texels"));
    m_levels->setRange(0, 16);
    m_levels->setSpecialValueText(tr("down to one texel"));
    for (QSpinBox* box : {m_size, m_border, m_levels})
        box->setKeyboardTracking(false);
    add(tr("&Name"), m_name, "export.name", tr("Letters, digits, - and _; names the files and the description beside them"));
    add(tr("&Map"), m_kind, "export.kind", tr("What is written"));
    add(tr("&Parameterization"), m_parameterization, "export.parameterization", tr("How directions become texels"));
    add(tr("&Size"), m_size, "export.size", tr("Edge of a face, disc or octahedron, or height of a latlong; arrows double and halve"));
    add(tr("&Border"), m_border, "export.border",
        tr("Texels between a disc and the edge of the picture; Blender shows a matcap's outline whole with 2 at 512"));
    add(tr("&Format"), m_format, "export.format", tr("File format and what a texel is stored as"));
    add({}, m_faces, "export.faces", tr("Cube: px, nx, py, ny, pz and nz instead of one stack"));
    add({}, m_mips, "export.mips", tr("Mip levels: each the halving of the one before, across seams; a painted map's as it makes them"));
    add({}, m_levelFiles, "export.level-files",
        tr("Numbered files instead of one that holds all levels; %d in the file's name stands for the number"));
    add(tr("&Levels"), m_levels, "export.levels", tr("How many levels of roughness; each is filtered from the probe itself"));
    add(tr("F&ile"), m_file, "export.file", tr("File name; %s in a cube's stands for the six faces, %d for the number of a level"));
    m_faces->setAccessibleName(tr("Six files"));
    m_levelFiles->setAccessibleName(tr("One file a level"));
    m_mips->setAccessibleName(tr("Halved levels"));
    m_rows->addRow(QString(), m_files);

    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        const std::string text = m_name->text().toStdString();
        change(tr("Export name"), [&](ExportTarget& t) { t.name = text; });
    });
    connect(m_kind, &QComboBox::activated, this, [this] {
        change(tr("Export map"), [this](ExportTarget& t) { t = withKind(t, static_cast<ExportKind>(m_kind->currentData().toInt())); });
    });
    connect(m_parameterization, &QComboBox::activated, this, [this] {
        change(tr("Export parameterization"), [this](ExportTarget& t) {
            t.parameterization = static_cast<Parameterization>(m_parameterization->currentData().toInt());
            if (t.parameterization != Parameterization::Paraboloid)
                t.border = 0;
            if (t.parameterization != Parameterization::Cube)
                t = withCubeFiles(t, CubeFiles::One);
        });
    });
    connect(m_size, &QSpinBox::valueChanged, this, [this](int size) {
        change(tr("Export size"), [size](ExportTarget& t) {
            t.size = size;
            t.border = std::min(t.border, (size - 1) / 2);
        });
    });
    connect(m_border, &QSpinBox::valueChanged, this,
            [this](int border) { change(tr("Export border"), [border](ExportTarget& t) { t.border = border; }); });
    connect(m_format, &QComboBox::activated, this, [this](int index) {
        change(tr("Export format"), [index](ExportTarget& t) { t = withFormat(t, exportFormats()[static_cast<size_t>(index)]); });
    });
    connect(m_faces, &QCheckBox::clicked, this, [this](bool six) {
        change(tr("Export files"), [six](ExportTarget& t) { t = withCubeFiles(t, six ? CubeFiles::Six : CubeFiles::One); });
    });
    connect(m_mips, &QCheckBox::clicked, this, [this](bool mips) {
        change(tr("Export levels"), [mips](ExportTarget& t) { t = withMips(t, mips ? Mips::All : Mips::None); });
    });
    connect(m_levelFiles, &QCheckBox::clicked, this, [this](bool each) {
        change(tr("Export files"), [each](ExportTarget& t) { t = withLevelFiles(t, each ? LevelFiles::Each : LevelFiles::One); });
    });
    connect(m_levels, &QSpinBox::valueChanged, this,
            [this](int levels) { change(tr("Export levels"), [levels](ExportTarget& t) { t.levels = levels; }); });
    connect(m_file, &QLineEdit::editingFinished, this, [this] {
        const std::string file = m_file->text().trimmed().toStdString();
        change(tr("Export file"), [&](ExportTarget& t) { t.file = file == t.name + ".exr" ? std::string() : file; });
    });
    return m_form;
}

/// A sphere map can be written where the scene has one.
void ExportDialog::offerKinds()
{
    const bool hasMap = !m_workspace.document.scene().material.sphereMap.isNone();
    m_addPainted->setEnabled(hasMap);
    m_addPainted->setToolTip(hasMap ? tr("The material's sphere map, for programs that take matcaps")
                                    : tr("The material has no sphere map"));
    const int item = m_kind->findData(static_cast<int>(ExportKind::Painted));
    if (auto* model = qobject_cast<QStandardItemModel*>(m_kind->model()))
        model->item(item)->setEnabled(hasMap);
}

QWidget* ExportDialog::makeFolderRow()
{
    auto* box = new QWidget;
    auto* layout = new QGridLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    m_folder = new QLineEdit;
    m_folder->setObjectName(QStringLiteral("export.folder"));
    m_folder->setAccessibleName(tr("Folder"));
    m_folder->setToolTip(tr("Where the files go; made when it is missing"));
    auto* label = new QLabel(tr("F&older"));
    label->setBuddy(m_folder);
    auto* browse = new QPushButton(tr("&Choose..."));
    browse->setObjectName(QStringLiteral("export.browse"));
    browse->setToolTip(tr("Chooses the folder"));
    browse->setAutoDefault(false);
    layout->addWidget(label, 0, 0, Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(m_folder, 0, 1);
    layout->addWidget(browse, 0, 2);
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString chosen = askForFolder(this, {.purpose = QStringLiteral("export"), .title = tr("Export into"), .start = folder()});
        if (!chosen.isEmpty())
            setFolder(chosen);
    });
    connect(m_folder, &QLineEdit::textChanged, this, &ExportDialog::showCommand);
    addCommandRow(*layout);
    return box;
}

void ExportDialog::addCommandRow(QGridLayout& layout)
{
    m_command = new QLineEdit;
    m_command->setObjectName(QStringLiteral("export.command"));
    m_command->setReadOnly(true);
    m_command->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_command->setAccessibleName(tr("Command line"));
    m_command->setToolTip(tr("Writes the same bytes without the studio"));
    auto* label = new QLabel(tr("Co&mmand line"));
    label->setBuddy(m_command);
    m_copy = new QPushButton(tr("Cop&y"));
    m_copy->setObjectName(QStringLiteral("export.copy"));
    m_copy->setToolTip(tr("Copies the command line"));
    m_copy->setAutoDefault(false);
    m_save = new QPushButton(tr("Sa&ve scene"));
    m_save->setObjectName(QStringLiteral("export.save"));
    m_save->setToolTip(tr("Saves the scene, which the command line reads"));
    m_save->setAutoDefault(false);
    layout.addWidget(label, 1, 0, Qt::AlignRight | Qt::AlignVCenter);
    layout.addWidget(m_command, 1, 1);
    layout.addWidget(m_copy, 1, 2);
    m_commandNote = quietLabel();
    layout.addWidget(m_commandNote, 2, 1);
    layout.addWidget(m_save, 2, 2);
    connect(m_copy, &QPushButton::clicked, this, [this] {
        QGuiApplication::clipboard()->setText(m_command->text());
        say(tr("The command line is on the clipboard."));
    });
    connect(m_save, &QPushButton::clicked, this, &ExportDialog::saveRequested);
}

void ExportDialog::setFolder(const QString& folder) { m_folder->setText(QDir::toNativeSeparators(folder)); }

QString ExportDialog::folder() const
{
    const QString text = QDir::fromNativeSeparators(m_folder->text().trimmed());
    return text.isEmpty() ? text : QDir(text).absolutePath();
}

int ExportDialog::selectedRow() const { return m_list->indexOfTopLevelItem(m_list->currentItem()); }

const ExportTarget* ExportDialog::selected() const
{
    const std::vector<ExportTarget>& targets = m_workspace.document.scene().exports;
    const int row = selectedRow();
    return row >= 0 && row < static_cast<int>(targets.size()) ? &targets[static_cast<size_t>(row)] : nullptr;
}

void ExportDialog::selectRow(int row)
{
    m_list->setCurrentItem(m_list->topLevelItem(std::min(row, m_list->topLevelItemCount() - 1)));
    showTarget();
}

void ExportDialog::change(const QString& label, const std::function<void(ExportTarget&)>& change)
{
    const int row = selectedRow();
    if (!selected())
        return;
    say({});
    m_workspace.document.edit(label, {}, [&](Scene& scene) { change(scene.exports[static_cast<size_t>(row)]); });
}

void ExportDialog::addTarget(ExportKind kind)
{
    const ExportTarget target = newTarget(m_workspace.document.scene(), kind);
    m_workspace.document.edit(tr("Add export"), {}, [&](Scene& scene) { scene.exports.push_back(target); });
    chooseEngine({}); // who adds a map wants the scene's own list
    selectRow(m_list->topLevelItemCount() - 1);
}

void ExportDialog::duplicateTarget()
{
    const ExportTarget* target = selected();
    if (!target)
        return;
    ExportTarget copy = *target;
    copy.name = freeName(m_workspace.document.scene().exports, copy.name);
    if (!copy.file.empty()) // two maps in one file would be one too few
        copy.file = copy.name + (hasFaceFiles(copy) ? "_%s" : "") + (hasLevelFiles(copy) ? "_%d" : "") +
                    std::filesystem::path(copy.file).extension().string();
    m_workspace.document.edit(tr("Duplicate export"), {}, [&](Scene& scene) { scene.exports.push_back(copy); });
    selectRow(m_list->topLevelItemCount() - 1);
}

void ExportDialog::removeTarget()
{
    const int row = selectedRow();
    if (!selected())
        return;
    m_workspace.document.edit(tr("Remove export"), {}, [row](Scene& scene) { scene.exports.erase(scene.exports.begin() + row); });
}

void ExportDialog::listTargets()
{
    const int row = std::max(0, selectedRow());
    {
        const QSignalBlocker blocker(m_list);
        m_list->clear();
        for (const ExportTarget& target : m_workspace.document.scene().exports) {
            const MapLayout layout = target.layout();
            const QString targetName = QString::fromStdString(target.name);
            auto* item = new QTreeWidgetItem(
                {targetName, kindText(target.kind),
                 QStringLiteral("%1 %2 × %3").arg(fieldText(name(layout.kind))).arg(layout.width()).arg(layout.height()), QString()});
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(NameColumn, m_unchecked.contains(targetName) ? Qt::Unchecked : Qt::Checked);
            item->setSizeHint(KindColumn, {0, fontMetrics().height() + 10}); // the column that stretches
            item->setTextAlignment(SizeColumn, Qt::AlignRight | Qt::AlignVCenter);
            m_list->addTopLevelItem(item);
        }
    }
    selectRow(row);
}

void ExportDialog::showTarget()
{
    const ExportTarget* target = selected();
    m_form->setEnabled(target != nullptr);
    m_duplicate->setEnabled(target != nullptr);
    m_remove->setEnabled(target != nullptr);
    const ExportTarget shown = target ? *target : ExportTarget{.name = "map"};
    const QSignalBlocker blockers[]{QSignalBlocker(m_size), QSignalBlocker(m_border), QSignalBlocker(m_levels)};
    m_name->setText(target ? QString::fromStdString(shown.name) : QString());
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(shown.kind)));
    m_parameterization->setCurrentIndex(m_parameterization->findData(static_cast<int>(shown.parameterization)));
    m_size->setRange(1, shown.kind == ExportKind::Painted ? largestSphereMap : 16384);
    m_size->setValue(shown.size);
    m_border->setRange(0, std::max(0, (shown.size - 1) / 2));
    m_border->setValue(shown.border);
    for (size_t i = 0; i < exportFormats().size(); ++i)
        m_format->setItemText(static_cast<int>(i), formatText(exportFormats()[i], shown.kind));
    m_format->setCurrentIndex(formatOf(shown));
    m_faces->setChecked(hasFaceFiles(shown));
    m_mips->setChecked(shown.mips);
    m_levelFiles->setChecked(hasLevelFiles(shown));
    m_levels->setValue(shown.levels);
    m_file->setPlaceholderText(QString::fromStdString(shown.name) + QStringLiteral(".exr"));
    m_file->setText(QString::fromStdString(shown.file));
    const bool isPainted = shown.kind == ExportKind::Painted, isChain = shown.kind == ExportKind::Chain;
    m_mips->setEnabled(canHaveMips(shown));
    m_rows->setRowVisible(m_parameterization, !isPainted);
    m_rows->setRowVisible(m_border, isPainted ? !shown.mips : shown.parameterization == Parameterization::Paraboloid);
    m_rows->setRowVisible(m_faces, !isPainted && shown.parameterization == Parameterization::Cube);
    m_rows->setRowVisible(m_mips, !isChain);
    m_rows->setRowVisible(m_levelFiles, (shown.mips || isChain) && (holdsMips(shown.fileName()) || hasLevelFiles(shown)));
    m_rows->setRowVisible(m_levels, isChain);
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
    const QSignalBlocker blocker(m_list);
    const ExportTarget* target = selected();
    std::int64_t bytes = 0;
    double seconds = 0.0;
    bool readsProbe = false;
    int files = 0;
    m_files->clear();
    for (int row = 0; row < m_list->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_list->topLevelItem(row);
        const auto found = std::find_if(m_estimates.begin(), m_estimates.end(),
                                        [&](const ExportEstimate& e) { return QString::fromStdString(e.name) == item->text(NameColumn); });
        item->setText(SizeColumn, found == m_estimates.end() ? QString() : toQString(byteText(found->fileBytes)));
        if (found == m_estimates.end())
            continue;
        if (target && found->name == target->name)
            m_files->setText(tr("%1, %2: about %3; %4 of texels before compression")
                                 .arg(filesText(found->files.size()),
                                      found->levels == 1 ? tr("one level") : tr("%1 levels").arg(found->levels),
                                      toQString(byteText(found->fileBytes)), toQString(byteText(found->texelBytes))));
        if (item->checkState(NameColumn) == Qt::Checked) {
            bytes += found->fileBytes;
            seconds += found->seconds;
            readsProbe |= !found->isPainted;
            files += static_cast<int>(found->files.size());
        }
    }
    if (readsProbe)
        seconds += m_sharedSeconds;
    if (m_list->topLevelItemCount() == 0)
        m_total->setText(tr("The scene exports nothing yet. Add a map to begin."));
    else if (files == 0)
        m_total->setText(m_estimates.empty() ? tr("No estimate yet.") : tr("No map is checked."));
    else
        m_total->setText(tr("%1, about %2 in all%3")
                             .arg(filesText(static_cast<size_t>(files)), toQString(byteText(bytes)),
                                  seconds == 0.0  ? QString()
                                  : seconds < 0.1 ? tr("; computed in less than 0.1 s")
                                                  : tr("; computed in about %1 s").arg(seconds, 0, 'f', 1)));
    m_export->setEnabled(canExport());
}

std::vector<std::string> ExportDialog::checkedNames() const
{
    std::vector<std::string> names;
    for (const ExportTarget& target : m_workspace.document.scene().exports)
        if (!m_unchecked.contains(QString::fromStdString(target.name)))
            names.push_back(target.name);
    return names;
}

void ExportDialog::showCommand()
{
    const Document& document = m_workspace.document;
    const std::vector<std::string> names = checkedNames();
    const bool isAll = names.size() == document.scene().exports.size();
    const bool isSaved = !document.filePath().isEmpty() && !document.isModified();
    const QString scene = document.filePath().isEmpty() ? QStringLiteral("SCENE.mirrorball") : document.filePath();
    m_command->setText(
        QString::fromStdString(m_engine ? engineExportCommand(toPath(scene), toPath(folder()), m_engine->word, m_card->size())
                                        : exportCommand(toPath(scene), toPath(folder()), isAll ? std::vector<std::string>{} : names)));
    m_command->setCursorPosition(0);
    m_command->setEnabled(isSaved);
    m_copy->setEnabled(isSaved && (m_engine || !names.empty()));
    m_save->setVisible(!isSaved);
    m_commandNote->setText(isSaved ? tr("Writes the same bytes as Export.")
                                   : tr("The command line reads the saved scene: save it first, then both write the same bytes."));
}

void ExportDialog::startExport()
{
    if (m_isExporting)
        return;
    if (folder().isEmpty()) {
        say(tr("Name the folder that the files go to."), true);
        m_folder->setFocus();
        return;
    }
    const std::vector<std::string> names = checkedNames();
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
