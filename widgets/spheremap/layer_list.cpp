#include "layer_list.h"

#include "layer_clipboard.h"

#include "widgets/controls/text.h"
#include "widgets/picture/screen_picture.h"

#include "core/base/error.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyledItemDelegate>

namespace mirrorball::studio {

namespace {

constexpr int thumbnailSize = 32, rowHeight = 40, eyeWidth = 28;
const QString layerMime = QStringLiteral("application/x-mirrorball-layer");

bool readsFiles(const LayerContent& content)
{
    return std::visit(
        [](const auto& layer) {
            return requires { std::string_view(layer.source); };
        },
        content);
}

class LayerDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {120, rowHeight}; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QStyleOptionViewItem item = option;
        initStyleOption(&item, index);
        item.text.clear();
        item.icon = {};
        const QWidget* widget = option.widget;
        (widget ? widget->style() : QApplication::style())->drawControl(QStyle::CE_ItemViewItem, &item, painter, widget);

        const bool visible = index.data(LayerModel::Visible).toBool();
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        paintEye(*painter, QRectF(option.rect.left(), option.rect.top(), eyeWidth, option.rect.height()), visible);
        const QRect picture(option.rect.left() + eyeWidth, option.rect.top() + (rowHeight - thumbnailSize) / 2, thumbnailSize,
                            thumbnailSize);
        painter->setOpacity(visible ? 1.0 : 0.4);
        painter->drawPixmap(picture, index.data(LayerModel::Thumbnail).value<QPixmap>());
        const QRect text = option.rect.adjusted(eyeWidth + thumbnailSize + 8, 4, -6, -4);
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        const QColor color = option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
        painter->setPen(color);
        painter->drawText(text, Qt::AlignLeft | Qt::AlignTop,
                          option.fontMetrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight, text.width()));
        QFont small = option.font;
        small.setPointSizeF(small.pointSizeF() * 0.86);
        painter->setFont(small);
        QColor faint = color;
        faint.setAlphaF(selected ? 0.85f : 0.65f);
        painter->setPen(faint);
        painter->drawText(text, Qt::AlignLeft | Qt::AlignBottom,
                          QFontMetrics(small).elidedText(index.data(LayerModel::Detail).toString(), Qt::ElideRight, text.width()));
        painter->restore();
    }

    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override
    {
        editor->setGeometry(option.rect.adjusted(eyeWidth + thumbnailSize + 4, 4, -4, -4));
    }

private:
    static void paintEye(QPainter& painter, const QRectF& area, bool visible)
    {
        const QPointF c = area.center();
        QPainterPath lids;
        lids.moveTo(c.x() - 7.0, c.y());
        lids.quadTo(c.x(), c.y() - 8.0, c.x() + 7.0, c.y());
        lids.quadTo(c.x(), c.y() + 8.0, c.x() - 7.0, c.y());
        painter.setPen(QPen(visible ? QColor(220, 220, 220) : QColor(110, 110, 110), 1.4));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(lids);
        if (visible) {
            painter.setBrush(QColor(220, 220, 220));
            painter.drawEllipse(c, 2.0, 2.0);
        } else {
            painter.drawLine(c + QPointF(-6, 6), c + QPointF(6, -6));
        }
    }
};

} // namespace

LayerModel::LayerModel(SphereMapEditor& editor, QObject* parent) : QAbstractListModel(parent), m_editor(editor)
{
    connect(&m_editor, &SphereMapEditor::mapChanged, this, &LayerModel::follow);
    follow();
}

void LayerModel::follow()
{
    const int rows = m_editor.map() ? static_cast<int>(m_editor.map()->layers.size()) : 0;
    if (rows != m_rows) {
        beginResetModel();
        m_rows = rows;
        endResetModel();
    } else if (rows > 0) {
        emit dataChanged(index(0), index(rows - 1));
    }
}

int LayerModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : m_rows; }

QVariant LayerModel::data(const QModelIndex& at, int role) const
{
    const size_t i = static_cast<size_t>(layerOf(at.row()));
    if (!m_editor.map() || i >= m_editor.map()->layers.size())
        return {};
    const Layer& layer = m_editor.map()->layers[i];
    const QString kind = fieldText(kindOf(layer.content).title);
    switch (role) {
    case Qt::EditRole:
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
        return layer.name.empty() ? kind : QString::fromStdString(layer.name);
    case Qt::ToolTipRole:
        return labelText(kindOf(layer.content).help);
    case Visible:
        return layer.visible;
    case Detail: {
        QStringList parts{kind};
        if (const auto* paint = std::get_if<PaintLayer>(&layer.content))
            parts[0] += paint->strokes.size() == 1 ? tr(", 1 stroke") : tr(", %1 strokes").arg(paint->strokes.size());
        if (layer.blend != BlendMode::Normal)
            parts << labelText(wordOf(layer.blend));
        if (layer.opacity < 1.0)
            parts << QStringLiteral("%1 %").arg(std::lround(100.0 * layer.opacity));
        if (layer.mask)
            parts << tr("masked");
        return parts.join(QStringLiteral(" · "));
    }
    case Thumbnail:
        return thumbnail(i);
    default:
        return {};
    }
}

QPixmap LayerModel::thumbnail(size_t i) const
{
    const LayerContent& content = m_editor.map()->layers[i].content;
    m_thumbnails.resize(m_editor.map()->layers.size());
    if (!m_thumbnails[i].second.isNull() && m_thumbnails[i].first == content)
        return m_thumbnails[i].second;
    constexpr int size = 2 * thumbnailSize; // for a screen of twice the density
    QPixmap pixmap(size, size);
    pixmap.fill(QColor(70, 70, 70));
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    if (kindOf(content).role == LayerRole::Generator && !readsFiles(content) && !std::holds_alternative<UnknownLayer>(content)) {
        try {
            SphereMapDocument alone;
            alone.layers = {{.content = content}};
            const QImage picture = onScreen(evaluate(alone, {.size = size}));
            QPainterPath disc;
            disc.addEllipse(1, 1, size - 2, size - 2);
            painter.setClipPath(disc);
            painter.fillRect(pixmap.rect(), QColor(96, 96, 96));
            painter.drawImage(0, 0, picture);
        } catch (const Error&) {
        }
    } else {
        QFont font = painter.font();
        font.setPixelSize(size / 2);
        painter.setFont(font);
        painter.setPen(QColor(220, 220, 220));
        painter.drawText(pixmap.rect(), Qt::AlignCenter, fieldText(kindOf(content).title).left(1).toUpper());
    }
    painter.end();
    pixmap.setDevicePixelRatio(2.0);
    m_thumbnails[i] = {content, pixmap};
    return pixmap;
}

bool LayerModel::setData(const QModelIndex& at, const QVariant& value, int role)
{
    const size_t i = static_cast<size_t>(layerOf(at.row()));
    if (role == Visible) {
        const bool visible = value.toBool();
        m_editor.edit(visible ? tr("Show layer") : tr("Hide layer"), {}, [&](SphereMapDocument& map) { map.layers[i].visible = visible; });
        return true;
    }
    if (role == Qt::EditRole) {
        const std::string name = value.toString().trimmed().toStdString();
        m_editor.edit(tr("Rename layer"), {}, [&](SphereMapDocument& map) { map.layers[i].name = name; });
        return true;
    }
    return false;
}

Qt::ItemFlags LayerModel::flags(const QModelIndex& at) const
{
    if (!at.isValid())
        return Qt::ItemIsDropEnabled; // between rows
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled;
}

QStringList LayerModel::mimeTypes() const { return {layerMime}; }

QMimeData* LayerModel::mimeData(const QModelIndexList& indexes) const
{
    auto* data = new QMimeData;
    if (!indexes.isEmpty())
        data->setData(layerMime, QByteArray::number(layerOf(indexes.first().row())));
    return data;
}

bool LayerModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int, const QModelIndex& parent)
{
    if (action != Qt::MoveAction || !data->hasFormat(layerMime))
        return false;
    const int from = data->data(layerMime).toInt();
    int before = row >= 0 ? row : parent.isValid() ? parent.row() : rowCount(); // the row that it comes to stand above
    if (rowOf(from) < before)
        --before; // its own row goes
    m_editor.moveLayer(from, layerOf(before));
    return false; // the view must not remove the row: the model has
}

LayerList::LayerList(SphereMapEditor& editor, QWidget* parent) : QListView(parent), m_editor(editor), m_model(new LayerModel(editor, this))
{
    setObjectName(QStringLiteral("layerList"));
    setAccessibleName(tr("Layers"));
    setToolTip(tr("The layers, the topmost first: drag to reorder, double-click to rename"));
    setModel(m_model);
    setItemDelegate(new LayerDelegate(this));
    setDragDropMode(QAbstractItemView::InternalMove);
    setDefaultDropAction(Qt::MoveAction);
    setDropIndicatorShown(true);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setUniformItemSizes(true);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    connect(&m_editor, &SphereMapEditor::chosenChanged, this, &LayerList::showChosen);
    connect(&m_editor, &SphereMapEditor::mapChanged, this, &LayerList::showChosen);
    showChosen();
}

void LayerList::showChosen()
{
    const QModelIndex wanted = m_editor.chosen() < 0 ? QModelIndex() : m_model->index(m_model->rowOf(m_editor.chosen()));
    if (currentIndex() != wanted)
        setCurrentIndex(wanted);
}

void LayerList::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    QListView::currentChanged(current, previous);
    if (current.isValid())
        m_editor.choose(m_model->layerOf(current.row()));
}

void LayerList::toggle(const QModelIndex& index)
{
    if (index.isValid())
        m_model->setData(index, !index.data(LayerModel::Visible).toBool(), LayerModel::Visible);
}

void LayerList::mousePressEvent(QMouseEvent* event)
{
    const QModelIndex at = indexAt(event->position().toPoint());
    if (event->button() == Qt::LeftButton && at.isValid() && event->position().x() < visualRect(at).left() + eyeWidth) {
        toggle(at);
        return;
    }
    QListView::mousePressEvent(event);
}

/// What can be done with the chosen layer.
void LayerList::fillMenu(QMenu& menu)
{
    const QModelIndex at = currentIndex();
    const int layer = m_editor.chosen(), last = m_model->rowCount() - 1;
    const auto add = [&](const QString& text, const QKeySequence& key, bool isPossible, auto act) {
        QAction* action = menu.addAction(text + u'\t' + key.toString(QKeySequence::NativeText), this, act); // shown, handled elsewhere
        action->setEnabled(isPossible);
    };
    add(at.data(LayerModel::Visible).toBool() ? tr("Hide") : tr("Show"), Qt::Key_Space, at.isValid(), [this, at] { toggle(at); });
    add(tr("Rename"), Qt::Key_F2, at.isValid(), [this, at] { edit(at); });
    menu.addSeparator();
    add(tr("Copy"), QKeySequence::Copy, at.isValid(), [this] { copyLayer(m_editor); });
    add(tr("Paste above"), QKeySequence::Paste, hasCopiedLayers(), [this] { pasteLayers(m_editor); });
    add(tr("Duplicate"), QKeySequence(QStringLiteral("Ctrl+D")), at.isValid(), [this] { m_editor.duplicateChosen(); });
    menu.addSeparator();
    add(tr("Move up"), QKeySequence(QStringLiteral("Ctrl+Up")), at.isValid() && layer < last,
        [this, layer] { m_editor.moveLayer(layer, layer + 1); });
    add(tr("Move down"), QKeySequence(QStringLiteral("Ctrl+Down")), layer > 0, [this, layer] { m_editor.moveLayer(layer, layer - 1); });
    menu.addSeparator();
    add(tr("Delete"), Qt::Key_Delete, at.isValid(), [this] { m_editor.removeChosen(); });
}

void LayerList::contextMenuEvent(QContextMenuEvent* event)
{
    if (event->reason() == QContextMenuEvent::Mouse)
        setCurrentIndex(indexAt(event->pos()));
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("layerMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu);
    const QPoint at =
        event->reason() == QContextMenuEvent::Mouse ? event->globalPos() : viewport()->mapToGlobal(visualRect(currentIndex()).center());
    menu->popup(at);
}

void LayerList::keyPressEvent(QKeyEvent* event)
{
    const bool control = event->modifiers().testFlag(Qt::ControlModifier);
    if (event->key() == Qt::Key_Space)
        toggle(currentIndex());
    else if (event->key() == Qt::Key_Delete)
        m_editor.removeChosen();
    else if (control && event->key() == Qt::Key_Up)
        m_editor.moveLayer(m_editor.chosen(), m_editor.chosen() + 1);
    else if (control && event->key() == Qt::Key_Down)
        m_editor.moveLayer(m_editor.chosen(), m_editor.chosen() - 1);
    else
        QListView::keyPressEvent(event);
}

} // namespace mirrorball::studio
