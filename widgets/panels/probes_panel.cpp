#include "probes_panel.h"

#include "probe_delegate.h"
#include "widgets/controls/file_dialogs.h"
#include "widgets/controls/scrolled.h"
#include "widgets/files/doctor_dialog.h"
#include "widgets/files/file_kind.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedLayout>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace mirrorball::studio {

ProbesPanel::ProbesPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_watcher(workspace), m_group(new QComboBox), m_find(new QLineEdit), m_list(new QListView),
      m_empty(new QLabel), m_details(new ProbeDetails(workspace, m_watcher))
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
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(stack);
    splitter->addWidget(scrolled(m_details));
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
    connect(&m_watcher, &ProbeWatcher::sourceChanged, this, &ProbesPanel::markChosen);
    listGroups();
    markChosen();
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

} // namespace mirrorball::studio
