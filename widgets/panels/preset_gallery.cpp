#include "preset_gallery.h"

#include <QApplication>
#include <QFrame>
#include <QKeyEvent>
#include <QPainter>
#include <QScreen>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>

namespace mirrorball::studio {

namespace {

constexpr int pad = 6;
constexpr int largestBall = PresetLibrary::pictureEdge, smallestBall = 84;

int ballIn(int cell) { return std::min(largestBall, cell - 2 * pad); }

/// A preset as a card: its ball and its name.
class PresetDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override
    {
        return {largestBall + 2 * pad, largestBall + option.fontMetrics.height() + 2 * pad + 4};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const QPalette& palette = option.palette;
        const bool isSelected = option.state.testFlag(QStyle::State_Selected);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setRenderHint(QPainter::SmoothPixmapTransform);
        if (isSelected || option.state.testFlag(QStyle::State_MouseOver)) {
            QColor ground = palette.color(isSelected ? QPalette::Highlight : QPalette::Light);
            ground.setAlphaF(isSelected ? 0.35f : 0.5f);
            painter->setPen(isSelected ? QPen(palette.color(QPalette::Highlight), 1.5) : QPen(Qt::NoPen));
            painter->setBrush(ground);
            painter->drawRoundedRect(QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
        }
        const int ball = ballIn(option.rect.width());
        const QRect picture(option.rect.left() + (option.rect.width() - ball) / 2, option.rect.top() + pad, ball, ball);
        const QImage image = index.data(Qt::DecorationRole).value<QImage>();
        if (image.isNull()) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(palette.color(QPalette::Mid));
            painter->drawEllipse(picture);
        } else {
            painter->drawImage(picture, image);
        }
        const QRect text(option.rect.left() + 3, picture.bottom() + 4, option.rect.width() - 6, option.fontMetrics.height());
        painter->setPen(palette.color(QPalette::Text));
        painter->drawText(text, Qt::AlignHCenter, option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, text.width()));
        painter->restore();
    }
};

} // namespace

PresetGallery::PresetGallery(PresetLibrary& library, QWidget* parent)
    : QWidget(parent), m_library(library), m_find(new QLineEdit), m_list(new QListView), m_description(new QLabel)
{
    setObjectName(QStringLiteral("presetGallery"));
    m_filter.setSourceModel(&library);
    m_filter.setFilterRole(PresetLibrary::SearchRole);
    m_filter.setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_find->setObjectName(QStringLiteral("presets.find"));
    m_find->setAccessibleName(tr("Find a preset"));
    m_find->setPlaceholderText(tr("Find a preset"));
    m_find->setToolTip(tr("Shows only presets whose names or descriptions hold these letters; Enter takes the one at hand"));
    m_find->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("presets.list"));
    m_list->setAccessibleName(tr("Presets"));
    m_list->setToolTip(tr("Click a preset, or press Enter on it, to take it"));
    m_list->setModel(&m_filter);
    m_list->setItemDelegate(new PresetDelegate(this));
    m_list->setViewMode(QListView::IconMode);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setMovement(QListView::Static);
    m_list->setUniformItemSizes(true);
    m_list->setMouseTracking(true);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // so that the columns know their width
    m_list->setMinimumSize(largestBall + 40, largestBall + 40);
    m_list->viewport()->installEventFilter(this);
    m_description->setWordWrap(true);
    m_description->setProperty("role", QStringLiteral("footnote"));
    m_description->setFixedHeight(2 * m_description->fontMetrics().lineSpacing() + 2);
    m_description->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_find);
    column->addWidget(m_list, 1);
    column->addWidget(m_description);
    connect(m_find, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_filter.setFilterFixedString(text.trimmed());
        m_list->setCurrentIndex(text.isEmpty() ? QModelIndex() : m_filter.index(0, 0));
        explain(m_list->currentIndex());
    });
    connect(m_list, &QListView::clicked, this, &PresetGallery::choose);
    connect(m_list, &QListView::activated, this, &PresetGallery::choose);
    connect(m_list, &QListView::entered, this, &PresetGallery::explain);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &PresetGallery::explain);
}

/// As many columns as there is room for, and they share all of it.
void PresetGallery::layOut()
{
    const int width = m_list->viewport()->width() - 1, columns = std::max(1, width / (smallestBall + 2 * pad)), cell = width / columns;
    m_list->setGridSize({cell, ballIn(cell) + m_list->fontMetrics().height() + 2 * pad + 8});
}

void PresetGallery::point(const QString& name)
{
    const int row = m_library.rowOf(name);
    const QModelIndex index = row < 0 ? QModelIndex() : m_filter.mapFromSource(m_library.index(row));
    m_list->setCurrentIndex(index);
    if (index.isValid())
        m_list->scrollTo(index);
}

void PresetGallery::explain(const QModelIndex& index)
{
    m_description->setText(index.isValid()            ? index.data(Qt::ToolTipRole).toString()
                           : m_filter.rowCount() == 0 ? tr("No preset has these letters in its name or description.")
                                                      : QString());
}

void PresetGallery::choose(const QModelIndex& index)
{
    if (index.isValid())
        emit chosen(index.data(PresetLibrary::NameRole).toString());
}

bool PresetGallery::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_list->viewport() && event->type() == QEvent::Resize)
        layOut();
    if (watched != m_find || event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        if (!m_list->currentIndex().isValid())
            m_list->setCurrentIndex(m_filter.index(0, 0));
        else
            QApplication::sendEvent(m_list, event);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        choose(m_list->currentIndex());
        return true;
    default:
        return false;
    }
}

PresetGallery* openPresetGallery(PresetLibrary& library, QWidget& beside, const QString& current)
{
    auto* frame = new QFrame(&beside, Qt::Popup);
    frame->setObjectName(QStringLiteral("presetPopup"));
    frame->setAttribute(Qt::WA_DeleteOnClose);
    frame->setFrameShape(QFrame::StyledPanel);
    auto* gallery = new PresetGallery(library, frame);
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(gallery);
    QObject::connect(gallery, &PresetGallery::chosen, frame, &QWidget::close);

    const QRect screen = beside.screen()->availableGeometry();
    frame->resize(std::min(5 * (largestBall + 2 * pad) + 44, screen.width() - 16), std::min(560, screen.height() - 16));
    const QPoint below = beside.mapToGlobal(QPoint(0, beside.height()));
    const auto within = [](int at, int size, int low, int high) { return std::max(low, std::min(at, high - size)); };
    frame->move(within(below.x(), frame->width(), screen.left() + 8, screen.right() - 8),
                within(below.y(), frame->height(), screen.top() + 8, screen.bottom() - 8));
    frame->show();
    gallery->find().setFocus();
    gallery->point(current);
    return gallery;
}

} // namespace mirrorball::studio
