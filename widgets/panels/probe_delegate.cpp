#include "probe_delegate.h"

#include "widgets/workspace/probe_library.h"

#include <QImage>
#include <QPainter>

namespace mirrorball::studio {

namespace {
constexpr QSize pictureSize(128, 64);
constexpr int pad = 6;
} // namespace

QSize ProbeDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    return {pictureSize.width() + 2 * pad, pictureSize.height() + 2 * option.fontMetrics.height() + 2 * pad + 4};
}

void ProbeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
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
    const QRect picture(option.rect.left() + (option.rect.width() - pictureSize.width()) / 2, option.rect.top() + pad, pictureSize.width(),
                        pictureSize.height());
    const QString problem = index.data(ProbeLibrary::ProblemRole).toString();
    const QImage thumbnail = index.data(Qt::DecorationRole).value<QImage>();
    if (!problem.isEmpty()) {
        painter->setPen(QColor(0xe0, 0x7a, 0x5f));
        painter->setBrush(QColor(0x2a, 0x20, 0x1e));
        painter->drawRect(picture.adjusted(0, 0, -1, -1));
        painter->drawText(picture, Qt::AlignCenter, tr("cannot be read"));
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

} // namespace mirrorball::studio
