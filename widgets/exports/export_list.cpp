#include "export_list.h"

#include "export_format.h"
#include "export_words.h"
#include "widgets/controls/disconnect_children.h"
#include "widgets/controls/text.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <filesystem>

namespace mirrorball::studio {

namespace {
enum Column { NameColumn, KindColumn, LayoutColumn, SizeColumn };
} // namespace

ExportList::ExportList(Document& document, QWidget* parent) : QWidget(parent), m_document(document)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    makeTree();
    layout->addWidget(m_tree, 1);
    layout->addLayout(makeButtons());
}

ExportList::~ExportList() { disconnectChildren(*this); }

void ExportList::makeTree()
{
    m_tree = new QTreeWidget;
    m_tree->setObjectName(QStringLiteral("export.list"));
    m_tree->setAccessibleName(tr("Maps to export"));
    m_tree->setRootIsDecorated(false);
    m_tree->setUniformRowHeights(true);
    m_tree->setColumnCount(4);
    m_tree->setHeaderLabels({tr("Name"), tr("Map"), tr("Layout"), tr("Size")});
    m_tree->headerItem()->setTextAlignment(SizeColumn, Qt::AlignRight | Qt::AlignVCenter);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(NameColumn, QHeaderView::ResizeToContents);
    m_tree->header()->setSectionResizeMode(KindColumn, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(LayoutColumn, QHeaderView::ResizeToContents);
    m_tree->header()->setSectionResizeMode(SizeColumn, QHeaderView::ResizeToContents);
    m_tree->setMinimumWidth(400);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &ExportList::showSelection);
    connect(m_tree, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item) {
        const QString name = item->text(NameColumn);
        m_unchecked.removeAll(name);
        if (item->checkState(NameColumn) == Qt::Unchecked)
            m_unchecked << name;
        emit checksChanged();
    });
}

QLayout* ExportList::makeButtons()
{
    auto* buttons = new QHBoxLayout;
    auto* more = new QPushButton(tr("&Add"));
    more->setObjectName(QStringLiteral("export.add"));
    more->setToolTip(tr("Adds a map to the list"));
    auto* menu = new QMenu(more);
    menu->setToolTipsVisible(true);
    for (const ExportKind kind : exportKinds)
        m_addPainted = menu->addAction(kindText(kind), this, [this, kind] { add(kind); }); // the last one
    more->setMenu(menu);
    m_duplicate = new QPushButton(tr("&Duplicate"));
    m_duplicate->setObjectName(QStringLiteral("export.duplicate"));
    m_duplicate->setToolTip(tr("Adds a copy of the selected map"));
    m_remove = new QPushButton(tr("&Remove"));
    m_remove->setObjectName(QStringLiteral("export.remove"));
    m_remove->setToolTip(tr("Takes the selected map off the list; files on disk stay"));
    for (QPushButton* button : {more, m_duplicate, m_remove}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    connect(m_duplicate, &QPushButton::clicked, this, &ExportList::duplicateSelected);
    connect(m_remove, &QPushButton::clicked, this, &ExportList::removeSelected);
    return buttons;
}

int ExportList::selectedRow() const { return m_tree->indexOfTopLevelItem(m_tree->currentItem()); }

const ExportTarget* ExportList::selected() const
{
    const std::vector<ExportTarget>& targets = m_document.scene().exports;
    const int row = selectedRow();
    return row >= 0 && row < static_cast<int>(targets.size()) ? &targets[static_cast<size_t>(row)] : nullptr;
}

void ExportList::selectRow(int row)
{
    m_tree->setCurrentItem(m_tree->topLevelItem(std::min(row, m_tree->topLevelItemCount() - 1)));
    showSelection();
}

std::vector<std::string> ExportList::checkedNames() const
{
    std::vector<std::string> names;
    for (const ExportTarget& target : m_document.scene().exports)
        if (!m_unchecked.contains(QString::fromStdString(target.name)))
            names.push_back(target.name);
    return names;
}

void ExportList::add(ExportKind kind)
{
    const ExportTarget target = newTarget(m_document.scene(), kind);
    m_document.edit(tr("Add export"), {}, [&](Scene& scene) { scene.exports.push_back(target); });
    selectRow(m_tree->topLevelItemCount() - 1);
    emit added();
}

void ExportList::duplicateSelected()
{
    const ExportTarget* target = selected();
    if (!target)
        return;
    ExportTarget copy = *target;
    copy.name = freeName(m_document.scene().exports, copy.name);
    if (!copy.file.empty()) // two maps in one file would be one too few
        copy.file = copy.name + (hasFaceFiles(copy) ? "_%s" : "") + (hasLevelFiles(copy) ? "_%d" : "") +
                    std::filesystem::path(copy.file).extension().string();
    m_document.edit(tr("Duplicate export"), {}, [&](Scene& scene) { scene.exports.push_back(copy); });
    selectRow(m_tree->topLevelItemCount() - 1);
}

void ExportList::removeSelected()
{
    const int row = selectedRow();
    if (!selected())
        return;
    m_document.edit(tr("Remove export"), {}, [row](Scene& scene) { scene.exports.erase(scene.exports.begin() + row); });
}

void ExportList::readScene()
{
    const int row = std::max(0, selectedRow());
    {
        const QSignalBlocker blocker(m_tree);
        m_tree->clear();
        for (const ExportTarget& target : m_document.scene().exports) {
            const MapLayout layout = target.layout();
            const QString targetName = QString::fromStdString(target.name);
            auto* item = new QTreeWidgetItem(
                {targetName, kindText(target.kind),
                 QStringLiteral("%1 %2 × %3").arg(fieldText(name(layout.kind))).arg(layout.width()).arg(layout.height()), QString()});
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(NameColumn, m_unchecked.contains(targetName) ? Qt::Unchecked : Qt::Checked);
            item->setSizeHint(KindColumn, {0, fontMetrics().height() + 10}); // the column that stretches
            item->setTextAlignment(SizeColumn, Qt::AlignRight | Qt::AlignVCenter);
            m_tree->addTopLevelItem(item);
        }
    }
    selectRow(row);
}

void ExportList::showSelection()
{
    m_duplicate->setEnabled(selected() != nullptr);
    m_remove->setEnabled(selected() != nullptr);
    emit selectionShown();
}

void ExportList::offerPainted(bool hasMap)
{
    m_addPainted->setEnabled(hasMap);
    m_addPainted->setToolTip(hasMap ? tr("The material's sphere map, for programs that take matcaps")
                                    : tr("The material has no sphere map"));
}

void ExportList::showEstimates(const std::vector<ExportEstimate>& estimates)
{
    const QSignalBlocker blocker(m_tree);
    for (int row = 0; row < m_tree->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_tree->topLevelItem(row);
        const auto found = std::find_if(estimates.begin(), estimates.end(),
                                        [&](const ExportEstimate& e) { return QString::fromStdString(e.name) == item->text(NameColumn); });
        item->setText(SizeColumn, found == estimates.end() ? QString() : toQString(byteText(found->fileBytes)));
    }
}

} // namespace mirrorball::studio
