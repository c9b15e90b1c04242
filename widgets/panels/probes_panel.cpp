#include "probes_panel.h"

#include "widgets/controls/color_scale_bar.h"
#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/keep_place.h"
#include "widgets/controls/text.h"
#include "widgets/files/doctor_dialog.h"
#include "widgets/files/file_kind.h"

#include "core/base/error.h"
#include "core/image/color_space.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedLayout>
#include <QStyledItemDelegate>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr QSize pictureSize(128, 64);
constexpr int pad = 6;

/// A probe as a card: its picture, its name, and what it is.
class ProbeDelegate : public QStyledItemDelegate {
public:
    explicit ProbeDelegate(const ProbeWatcher& watcher, QObject* parent) : QStyledItemDelegate(parent), m_watcher(watcher) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override
    {
        return {pictureSize.width() + 2 * pad, pictureSize.height() + 2 * option.fontMetrics.height() + 2 * pad + 4};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const QPalette& palette = option.palette;
        const bool isChosen = index.data(ProbeLibrary::SourceRole).toString() == m_watcher.source();
        const bool isSelected = option.state.testFlag(QStyle::State_Selected), isFocused = option.state.testFlag(QStyle::State_HasFocus);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setRenderHint(QPainter::SmoothPixmapTransform);
        const QRectF card = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
        if (isChosen || isSelected || option.state.testFlag(QStyle::State_MouseOver)) {
            QColor ground = palette.color(isChosen || isSelected ? QPalette::Highlight : QPalette::Mid);
            ground.setAlphaF(isChosen ? 0.35f : 0.18f);
            painter->setPen(isChosen || isFocused ? QPen(palette.color(QPalette::Highlight), isFocused ? 2.0 : 1.0) : QPen(Qt::NoPen));
            painter->setBrush(ground);
            painter->drawRoundedRect(card, 4, 4);
        }
        const QRect picture(option.rect.left() + (option.rect.width() - pictureSize.width()) / 2, option.rect.top() + pad,
                            pictureSize.width(), pictureSize.height());
        const QString problem = index.data(ProbeLibrary::ProblemRole).toString();
        const QImage thumbnail = index.data(Qt::DecorationRole).value<QImage>();
        if (!problem.isEmpty()) {
            painter->setPen(QColor(0xe0, 0x7a, 0x5f));
            painter->setBrush(QColor(0x2a, 0x20, 0x1e));
            painter->drawRect(picture.adjusted(0, 0, -1, -1));
            painter->drawText(picture, Qt::AlignCenter, ProbesPanel::tr("cannot be read"));
        } else if (thumbnail.isNull()) {
            painter->fillRect(picture, palette.color(QPalette::Base));
            painter->setPen(palette.color(QPalette::PlaceholderText));
            painter->drawText(picture, Qt::AlignCenter, QStringLiteral("..."));
        } else {
            painter->drawImage(picture, thumbnail);
            if (!index.data(ProbeLibrary::CertainRole).toBool()) {
                const QRect badge(picture.right() - 19, picture.top() + 3, 16, 16);
                painter->setPen(Qt::NoPen);
                painter->setBrush(QColor(0xe9, 0xc4, 0x6a));
                painter->drawEllipse(badge);
                painter->setPen(Qt::black);
                painter->drawText(badge, Qt::AlignCenter, QStringLiteral("?"));
            }
        }
        const int line = option.fontMetrics.height();
        const QRect text(option.rect.left() + pad, picture.bottom() + 3, option.rect.width() - 2 * pad, line);
        painter->setPen(palette.color(QPalette::Text));
        painter->drawText(text, Qt::AlignHCenter, option.fontMetrics.elidedText(index.data().toString(), Qt::ElideMiddle, text.width()));
        painter->setPen(palette.color(QPalette::PlaceholderText));
        painter->drawText(text.translated(0, line), Qt::AlignHCenter,
                          option.fontMetrics.elidedText(index.data(ProbeLibrary::FactsRole).toString(), Qt::ElideRight, text.width()));
        painter->restore();
    }

private:
    const ProbeWatcher& m_watcher;
};

/// What of a reading the facts of a file depend on.
ProbeReading withoutTurn(ProbeReading reading)
{
    reading.mirror = MirrorAxis::None;
    reading.rotateDeg = glm::dvec3(0.0);
    return reading;
}

QString rangeText(const ProbeStatistics& s)
{
    QString text = ProbesPanel::tr("%1 to %2").arg(shortNumberText(s.minLuminance), shortNumberText(s.maxLuminance));
    if (s.minLuminance > 0.0 && s.maxLuminance > s.minLuminance)
        text += ProbesPanel::tr(" (%1 stops)").arg(std::log2(s.maxLuminance / s.minLuminance), 0, 'f', 1);
    return text;
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

void ProbeFilter::setGroup(const QString& group)
{
    m_group = group;
    invalidateFilter();
}

void ProbeFilter::setText(const QString& text)
{
    m_text = text;
    invalidateFilter();
}

bool ProbeFilter::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    return (m_group.isEmpty() || index.data(ProbeLibrary::GroupRole).toString() == m_group) &&
           (m_text.isEmpty() || index.data().toString().contains(m_text, Qt::CaseInsensitive));
}

ProbesPanel::ProbesPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_watcher(workspace), m_survey(this), m_group(new QComboBox), m_find(new QLineEdit),
      m_list(new QListView), m_empty(new QLabel), m_name(new QLabel), m_facts(new QLabel), m_guessText(new QLabel), m_guesses(new QWidget),
      m_readAs(new QComboBox), m_progress(new QProgressBar)
{
    m_filter.setSourceModel(&workspace.library);
    m_list->setObjectName(QStringLiteral("probes.list"));
    m_list->setAccessibleName(tr("Probes"));
    m_list->setToolTip(tr("Click a probe, or press Enter on it, to light the scene with it; Delete takes a single file off the list"));
    m_list->setModel(&m_filter);
    m_list->setItemDelegate(new ProbeDelegate(m_watcher, this));
    m_list->setViewMode(QListView::IconMode);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setMovement(QListView::Static);
    m_list->setUniformItemSizes(true);
    m_list->setSpacing(2);
    m_list->setMouseTracking(true);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setMinimumHeight(150);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setMargin(16);

    auto* stack = new QWidget;
    auto* stacked = new QStackedLayout(stack);
    stacked->addWidget(m_list);
    stacked->addWidget(m_empty);
    auto* scroll = new QScrollArea;
    scroll->setWidget(makeDetails());
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(stack);
    splitter->addWidget(scroll);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(makeGroupRow());
    layout->addWidget(splitter, 1);

    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_list, &QWidget::customContextMenuRequested, this, &ProbesPanel::showMenu);
    connect(m_list, &QListView::clicked, this, &ProbesPanel::choose);
    connect(m_list, &QListView::activated, this, &ProbesPanel::choose);
    connect(&m_filter, &QAbstractItemModel::modelReset, this, &ProbesPanel::showEmptiness);
    connect(&m_filter, &QAbstractItemModel::rowsInserted, this, &ProbesPanel::showEmptiness);
    connect(&m_filter, &QAbstractItemModel::rowsRemoved, this, &ProbesPanel::showEmptiness);
    connect(&workspace.library, &ProbeLibrary::foldersChanged, this, &ProbesPanel::listGroups);
    connect(&m_watcher, &ProbeWatcher::sourceChanged, this, [this] {
        m_kinds.clear();
        m_isCertain = true;
        markChosen();
        survey();
    });
    connect(&m_watcher, &ProbeWatcher::fileChanged, this, &ProbesPanel::survey);
    connect(&workspace.document, &Document::changed, this, [this](Parts parts) {
        if (!parts.testFlag(Part::Probe))
            return;
        if (withoutTurn(m_workspace.document.scene().probe.reading) != m_reading)
            survey();
        else
            readScene();
    });
    connect(&m_survey, &JobRunner::failed, this, &ProbesPanel::showProblem);
    connect(&m_survey, &JobRunner::progressed, this, [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&m_survey, &JobRunner::busyChanged, this, [this](bool busy) { m_progress->setVisible(busy); });
    listGroups();
    markChosen();
    survey();
}

QWidget* ProbesPanel::makeGroupRow()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_group->setObjectName(QStringLiteral("probes.group"));
    m_group->setAccessibleName(tr("Which probes"));
    m_group->setToolTip(tr("Which probes are listed"));
    m_group->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_group->setMinimumContentsLength(7);
    m_find->setObjectName(QStringLiteral("probes.find"));
    m_find->setAccessibleName(tr("Find a probe"));
    m_find->setPlaceholderText(tr("Find"));
    m_find->setToolTip(tr("Lists only probes whose names hold these letters"));
    m_find->setMinimumWidth(60);
    auto* add = new QToolButton;
    add->setObjectName(QStringLiteral("probes.add"));
    add->setText(tr("Add"));
    add->setAccessibleName(tr("Add probes"));
    add->setToolTip(tr("Adds image files or a whole folder; dropping them on the window does the same"));
    add->setPopupMode(QToolButton::InstantPopup);
    add->setFocusPolicy(Qt::StrongFocus);
    auto* menu = new QMenu(add);
    menu->addAction(tr("Folder..."), this, [this] {
        const QString folder = askForFolder(this, {.purpose = QStringLiteral("probes"), .title = tr("Add a folder of probes")});
        if (!folder.isEmpty()) {
            m_workspace.library.addFolder(folder);
            m_group->setCurrentIndex(m_group->findData(QDir(folder).absolutePath()));
        }
    });
    menu->addAction(tr("Files..."), this, [this] {
        for (const QString& file :
             askForFiles(this, {.purpose = QStringLiteral("probes"), .title = tr("Add probes"), .filter = filterOf(FileKind::Picture)}))
            m_workspace.library.addFile(file);
    });
    QAction* remove = menu->addAction(tr("Remove this folder from the list"), this,
                                      [this] { m_workspace.library.removeFolder(m_group->currentData().toString()); });
    QAction* removeOne = menu->addAction(tr("Remove the selected file from the list"), this, &ProbesPanel::removeFile);
    removeOne->setObjectName(QStringLiteral("probes.remove-file"));
    removeOne->setShortcut(QKeySequence::Delete);
    removeOne->setShortcutContext(Qt::WidgetShortcut);
    m_list->addAction(removeOne);
    QAction* removeMissing = menu->addAction(tr("Remove missing files from the list"), this, [this] {
        for (const QString& file : m_workspace.library.missingFiles())
            m_workspace.library.removeFile(file);
    });
    removeMissing->setObjectName(QStringLiteral("probes.remove-missing"));
    connect(menu, &QMenu::aboutToShow, this, [this, remove, removeOne, removeMissing] {
        remove->setEnabled(m_workspace.library.folders().contains(m_group->currentData().toString()));
        removeOne->setEnabled(!removableFile().isEmpty());
        removeMissing->setEnabled(!m_workspace.library.missingFiles().isEmpty());
    });
    connect(menu, &QMenu::aboutToHide, removeOne, [removeOne] { removeOne->setEnabled(true); }); // its key works without the menu
    add->setMenu(menu);
    layout->addWidget(m_group, 1);
    layout->addWidget(m_find, 1);
    layout->addWidget(add);
    connect(m_group, &QComboBox::currentIndexChanged, this, [this] {
        m_filter.setGroup(m_group->currentData().toString());
        showEmptiness();
    });
    connect(m_find, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_filter.setText(text);
        showEmptiness();
    });
    return row;
}

/// The selected card's file, where it is listed by itself; empty for built-in probes and those of a folder.
QString ProbesPanel::removableFile() const
{
    const QModelIndex index = m_list->currentIndex();
    return index.data(ProbeLibrary::GroupRole).toString() == ProbeLibrary::filesGroup() ? index.data(ProbeLibrary::SourceRole).toString()
                                                                                        : QString();
}

void ProbesPanel::removeFile()
{
    if (const QString file = removableFile(); !file.isEmpty())
        m_workspace.library.removeFile(file);
}

QWidget* ProbesPanel::makeDetails()
{
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 4, 4, 0);
    layout->setSpacing(6);
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
    m_readAs->setObjectName(QStringLiteral("probes.read_as"));
    m_readAs->setAccessibleName(tr("Read as"));
    m_readAs->setToolTip(tr("How the file shows the sphere"));
    connect(m_readAs, &QComboBox::activated, this, [this] {
        const int kind = m_readAs->currentData().toInt();
        readAs(kind < 0 ? std::nullopt : std::optional(static_cast<Parameterization>(kind)));
    });
    layout->addWidget(m_name);
    layout->addWidget(m_guessText);
    layout->addWidget(m_guesses);
    layout->addWidget(m_facts);
    layout->addWidget(m_progress);
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
    layout->addWidget(form);
    layout->addStretch(1);
    return box;
}

void ProbesPanel::listGroups()
{
    const QVariant before = m_group->currentData();
    {
        const QSignalBlocker blocker(m_group);
        m_group->clear();
        m_group->addItem(tr("All probes"), QString());
        m_group->addItem(tr("Built in"), ProbeLibrary::builtinGroup());
        m_group->addItem(tr("Single files"), ProbeLibrary::filesGroup());
        for (const QString& folder : m_workspace.library.folders()) {
            m_group->addItem(QDir(folder).dirName(), folder);
            m_group->setItemData(m_group->count() - 1, QDir::toNativeSeparators(folder), Qt::ToolTipRole);
        }
        m_group->setCurrentIndex(std::max(0, m_group->findData(before)));
    }
    m_filter.setGroup(m_group->currentData().toString());
    showEmptiness();
}

void ProbesPanel::showEmptiness()
{
    const QString group = m_group->currentData().toString();
    QString text;
    if (m_filter.rowCount() == 0) {
        if (!m_find->text().isEmpty())
            text = tr("No probe here has \"%1\" in its name.").arg(m_find->text());
        else if (group == ProbeLibrary::filesGroup())
            text = tr("No single files yet. Drop an .hdr or .exr file anywhere on the window.");
        else if (!QDir(group).exists())
            text = tr("The folder %1 is gone. Remove it from the list, or put it back.").arg(QDir::toNativeSeparators(group));
        else
            text = tr("This folder holds no .hdr, .exr or other image files.");
    }
    m_empty->setText(text);
    auto* stacked = static_cast<QStackedLayout*>(m_list->parentWidget()->layout());
    stacked->setCurrentWidget(text.isEmpty() ? static_cast<QWidget*>(m_list) : m_empty);
    markChosen();
}

void ProbesPanel::choose(const QModelIndex& index)
{
    const QString source = index.data(ProbeLibrary::SourceRole).toString();
    if (source.isEmpty() || source == m_watcher.source())
        return;
    m_workspace.document.edit(tr("Probe"), {}, [&](Scene& scene) {
        scene.probe.source = source.toStdString();
        scene.probe.reading = {};
    });
}

/// What can be done with a probe of the list, whether it is chosen or not.
void ProbesPanel::showMenu(const QPoint& position)
{
    const QModelIndex at = m_list->indexAt(position).isValid() ? m_list->indexAt(position) : m_list->currentIndex();
    if (!at.isValid())
        return;
    const QString source = at.data(ProbeLibrary::SourceRole).toString();
    const bool isFile = at.data(ProbeLibrary::GroupRole).toString() != ProbeLibrary::builtinGroup();
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("probeMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Light the scene with it"), this, [this, at] { choose(at); });
    menu->addAction(tr("Read its picture anew"), this, [this, source] { m_workspace.library.refresh(source); })->setEnabled(isFile);
    menu->addAction(tr("What is this map?"), this, [this, source] { (new DoctorDialog(m_workspace, source, window()))->open(); })
        ->setEnabled(isFile);
    menu->addSeparator();
    menu->addAction(tr("Copy its path"), this, [source] { QGuiApplication::clipboard()->setText(QDir::toNativeSeparators(source)); });
    menu->addAction(tr("Open its folder"), this,
                    [source] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(source).absolutePath())); })
        ->setEnabled(isFile);
    menu->addSeparator();
    menu->addAction(tr("Remove from the list"), this, [this, source] { m_workspace.library.removeFile(source); })
        ->setEnabled(at.data(ProbeLibrary::GroupRole).toString() == ProbeLibrary::filesGroup());
    menu->popup(m_list->viewport()->mapToGlobal(position));
}

/// The chosen probe is current in the list. One of a scene that no folder holds joins the single files.
void ProbesPanel::markChosen()
{
    const QString& source = m_watcher.source();
    if (m_workspace.library.rowOf(source) < 0 && QFileInfo::exists(source))
        m_workspace.library.addFile(source);
    const int row = m_workspace.library.rowOf(source);
    const QModelIndex index = m_filter.mapFromSource(m_workspace.library.index(row));
    if (index.isValid() && m_list->currentIndex() != index) {
        m_list->setCurrentIndex(index);
        m_list->scrollTo(index);
    }
    m_list->viewport()->update();
}

void ProbesPanel::survey()
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

void ProbesPanel::showSurvey(const ProbeSurvey& survey, const std::vector<ProbeGuess>& guessed)
{
    const ReducedProbe& probe = survey.reduced;
    const ProbeStatistics& s = survey.statistics;
    m_kinds = possibleKinds(probe);
    std::sort(m_kinds.begin(), m_kinds.end());
    m_isCertain = probe.detection.certain;
    std::vector<std::pair<QString, QString>> rows{
        {tr("size"), QStringLiteral("%1 × %2").arg(probe.info.width).arg(probe.info.height)},
        {tr("kind"), QStringLiteral("%1: %2").arg(fieldText(name(probe.detection.layout.kind)), toQString(probe.detection.reason))},
        {tr("luminance"), rangeText(s)},
        {tr("mean"), shortNumberText(s.meanLuminance)},
        {tr("sun"), tr("the brightest 0.01 % hold %1 % of the energy").arg(100.0 * s.sunShare, 0, 'f', 1)},
        {tr("texels"), toQString(describe(probe.repaired))}};
    for (const Assumption& a : allAssumed(probe.info, probe.detection))
        if (a.topic != "parameterization" && (a.certainty != Certainty::Certain || !a.others.empty()))
            rows.push_back({toQString(a.topic), toQString(a.value)});
    for (const std::string& note : allNotes(probe.info, probe.detection))
        rows.push_back({tr("note"), toQString(note)});
    if (s.beyondHalf > 0)
        rows.push_back({tr("half float"), s.beyondHalf == 1 ? tr("1 value beyond 65504") : tr("%1 values beyond 65504").arg(s.beyondHalf)});
    m_facts->setText(table(rows));
    m_guessText->setText(m_isCertain ? QString()
                                     : tr("The shape fits several kinds. The right one has a level horizon and straight verticals:"));
    m_guessText->setVisible(!m_isCertain);
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
    readScene();
    const bool isBall = probe.detection.arrangement == Arrangement::Ball;
    for (QToolButton* button : guesses())
        button->setChecked(
            button->objectName().endsWith(u'.' + (isBall ? QStringLiteral("ball") : toQString(name(probe.detection.layout.kind)))));
}

void ProbesPanel::showProblem(const QString& message)
{
    m_kinds.assign(allParameterizations.begin(), allParameterizations.end()); // with a fit it may be any
    m_guessText->hide();
    m_guesses->hide();
    m_facts->setText(QStringLiteral("<span style='color:#e07a5f'>%1</span>").arg(message.toHtmlEscaped()));
    readScene();
}

QList<QToolButton*> ProbesPanel::guesses() const { return m_guesses->findChildren<QToolButton*>(); }

void ProbesPanel::readAs(std::optional<Parameterization> kind, std::optional<Fit> fit)
{
    m_workspace.document.edit(tr("Read probe as"), {}, [&](Scene& scene) {
        scene.probe.reading.parameterization = kind;
        if (fit)
            scene.probe.reading.fit = *fit;
    });
}

void ProbesPanel::readScene()
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
