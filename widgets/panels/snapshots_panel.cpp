#include "snapshots_panel.h"

#include "widgets/controls/options_form.h"

#include <QHBoxLayout>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace mirrorball::studio {

SnapshotsPanel::SnapshotsPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_list(new QListWidget), m_compare(new QuietCombo), m_figures(new QLabel)
{
    m_list->setObjectName(QStringLiteral("snapshots.list"));
    m_list->setAccessibleName(tr("Snapshots"));
    m_list->setToolTip(tr("The chosen one is A, which is compared with what is shown now; F2 renames it, Delete takes it off the list"));
    m_list->setIconSize(Snapshots::thumbnailSize);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->setMinimumHeight(Snapshots::thumbnailSize.height() + 12);
    m_compare->setObjectName(QStringLiteral("snapshots.compare"));
    m_compare->setAccessibleName(tr("Compare"));
    m_compare->setToolTip(tr("How the chosen snapshot, A, is compared with what is shown now, B"));
    for (const auto& [comparison, text] : {std::pair{Comparison::Off, tr("Off")},
                                           {Comparison::Hold, tr("The snapshot")},
                                           {Comparison::Wipe, tr("Wipe")},
                                           {Comparison::SideBySide, tr("Side by side")},
                                           {Comparison::Difference, tr("Difference")}})
        m_compare->addItem(text, static_cast<int>(comparison));
    m_figures->setObjectName(QStringLiteral("snapshots.figures"));
    m_figures->setWordWrap(true);
    m_figures->setToolTip(tr("Of the display values (sRGB, 0 to 1) of the two pictures as they are shown, A being the reference: relative "
                             "root mean square, peak signal to noise, structural similarity of the luma"));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    column->addWidget(makeButtons());
    column->addWidget(m_list, 1);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("&Compare"));
    label->setBuddy(m_compare);
    row->addWidget(label);
    row->addWidget(m_compare, 1);
    column->addLayout(row);
    column->addWidget(m_figures);

    Snapshots& snapshots = m_workspace.snapshots;
    connect(m_list, &QListWidget::currentRowChanged, this, [&snapshots](int index) {
        if (index >= 0)
            snapshots.choose(index);
    });
    connect(m_list, &QListWidget::itemChanged, this,
            [this, &snapshots](const QListWidgetItem* item) { snapshots.rename(m_list->row(item), item->text()); });
    connect(m_compare, &QComboBox::activated, this,
            [this, &snapshots] { snapshots.setComparison(static_cast<Comparison>(m_compare->currentData().toInt())); });
    auto* remove = new QShortcut(QKeySequence(Qt::Key_Delete), m_list, nullptr, nullptr, Qt::WidgetShortcut);
    connect(remove, &QShortcut::activated, this, &SnapshotsPanel::removeChosen);
    connect(&snapshots, &Snapshots::listChanged, this, &SnapshotsPanel::showList, Qt::QueuedConnection); // an item may be in its edit
    connect(&snapshots, &Snapshots::comparisonChanged, this, &SnapshotsPanel::showComparison);
    connect(&snapshots, &Snapshots::errorChanged, this, &SnapshotsPanel::showComparison);
    showList();
    showComparison();
}

QPushButton* SnapshotsPanel::addButton(const char* name, const QString& text, const QString& help)
{
    auto* button = new QPushButton(text);
    button->setAccessibleName(text);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(help);
    button->setAutoDefault(false);
    return button;
}

QWidget* SnapshotsPanel::makeButtons()
{
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    m_back = addButton("snapshots.back", tr("Bring back"),
                       tr("Make the scene what the chosen snapshot keeps, seen from where the camera is now; undo takes it back"));
    m_rename = addButton("snapshots.rename", tr("Rename"), tr("Give the chosen snapshot another name (F2)"));
    m_remove = addButton("snapshots.remove", tr("Delete"), tr("Take the chosen snapshot off the list"));
    for (QPushButton* button : {m_back, m_rename, m_remove})
        row->addWidget(button);
    row->addStretch(1);
    connect(m_back, &QPushButton::clicked, this, &SnapshotsPanel::bringBack);
    connect(m_rename, &QPushButton::clicked, this, [this] {
        if (QListWidgetItem* item = m_list->currentItem())
            m_list->editItem(item);
    });
    connect(m_remove, &QPushButton::clicked, this, &SnapshotsPanel::removeChosen);
    return buttons;
}

void SnapshotsPanel::showList()
{
    const Snapshots& snapshots = m_workspace.snapshots;
    const QSignalBlocker quiet(m_list);
    const int count = static_cast<int>(snapshots.all().size());
    while (m_list->count() > count)
        delete m_list->takeItem(count);
    for (int i = 0; i < count; ++i) {
        const Snapshot& snapshot = snapshots.all()[static_cast<size_t>(i)];
        QListWidgetItem* item = i < m_list->count() ? m_list->item(i) : new QListWidgetItem(m_list);
        if (!item->flags().testFlag(Qt::ItemIsEditable))
            item->setFlags(item->flags() | Qt::ItemIsEditable);
        // Only what has changed: a name may be in its edit, and would be taken out of it.
        if (const qint64 key = snapshot.thumbnail.cacheKey(); item->data(Qt::UserRole) != key) {
            item->setData(Qt::UserRole, key);
            QIcon picture(QPixmap::fromImage(snapshot.thumbnail));
            picture.addPixmap(QPixmap::fromImage(snapshot.thumbnail), QIcon::Selected); // not tinted
            item->setIcon(picture);
        }
        item->setText(snapshot.name);
        item->setToolTip(snapshot.name);
    }
    m_list->setCurrentRow(snapshots.chosen());
    for (QPushButton* button : {m_back, m_rename, m_remove})
        button->setEnabled(snapshots.compared() != nullptr);
    showComparison();
}

void SnapshotsPanel::showComparison()
{
    const Snapshots& snapshots = m_workspace.snapshots;
    m_compare->setEnabled(snapshots.compared() != nullptr);
    m_compare->setCurrentIndex(m_compare->findData(static_cast<int>(snapshots.comparison())));
    const bool isMeasured = snapshots.comparison() != Comparison::Off && snapshots.comparison() != Comparison::Hold;
    m_figures->setText(snapshots.all().empty() ? tr("No snapshot is kept: Ctrl+K keeps what is shown, to be compared with what comes.")
                       : isMeasured            ? errorText(snapshots.error())
                                               : tr("Wipe, side by side and difference say how far B is from A."));
}

void SnapshotsPanel::bringBack()
{
    const Snapshot* kept = m_workspace.snapshots.compared();
    if (kept)
        m_workspace.document.edit(tr("Bring back %1").arg(kept->name), {}, [kept](Scene& scene) { scene = broughtBack(*kept, scene); });
}

void SnapshotsPanel::removeChosen()
{
    if (m_workspace.snapshots.compared())
        m_workspace.snapshots.remove(m_workspace.snapshots.chosen());
}

} // namespace mirrorball::studio
