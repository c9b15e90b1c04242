#include "comparison_labels.h"

#include <QEvent>

namespace mirrorball::studio {

namespace {
constexpr int margin = 8; ///< pixels
}

ComparisonLabels::ComparisonLabels(const Snapshots& snapshots, QWidget& picture)
    : QObject(&picture), m_snapshots(snapshots), m_picture(picture), m_a(add("compare.a")), m_b(add("compare.b")),
      m_figures(add("compare.figures"))
{
    connect(&m_snapshots, &Snapshots::comparisonChanged, this, &ComparisonLabels::follow);
    connect(&m_snapshots, &Snapshots::errorChanged, this, &ComparisonLabels::follow);
    m_picture.installEventFilter(this);
    follow();
}

QLabel* ComparisonLabels::add(const char* name)
{
    auto* label = new QLabel(&m_picture);
    label->setObjectName(QLatin1String(name));
    label->setProperty("role", QStringLiteral("pictureLabel"));
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->setTextFormat(Qt::PlainText);
    return label;
}

void ComparisonLabels::setWipe(double fraction)
{
    m_wipe = fraction;
    follow();
}

/// Shows the text between two columns of the picture; not at all where only a letter or two would find room.
void ComparisonLabels::put(QLabel& label, const QString& text, int left, int right)
{
    const int room = right - left - 2 * margin;
    label.setText(text);
    const int frame = label.sizeHint().width() - label.fontMetrics().horizontalAdvance(text);
    const bool fits = !text.isEmpty() && room >= frame + label.fontMetrics().horizontalAdvance(QStringLiteral("A: mm…"));
    label.setVisible(fits);
    if (!fits)
        return;
    label.setText(label.fontMetrics().elidedText(text, Qt::ElideMiddle, room - frame));
    label.adjustSize();
    label.move(left + margin, margin);
}

void ComparisonLabels::follow()
{
    const Snapshot* kept = m_snapshots.compared();
    const Comparison comparison = kept ? m_snapshots.comparison() : Comparison::Off;
    const QString a = kept ? tr("A: %1").arg(kept->name) : QString(), b = tr("B: now");
    const int width = m_picture.width(), line = static_cast<int>(m_wipe * width), middle = (width + 1) / 2;
    switch (comparison) {
    case Comparison::Off:
        put(*m_a, {}, 0, width);
        put(*m_b, {}, 0, width);
        break;
    case Comparison::Hold:
        put(*m_a, a, 0, width);
        put(*m_b, {}, 0, width);
        break;
    case Comparison::Wipe:
        put(*m_a, a, 0, line);
        put(*m_b, b, line, width);
        m_b->move(std::max(line + margin, width - m_b->width() - margin), margin);
        break;
    case Comparison::SideBySide:
        put(*m_a, a, 0, middle);
        put(*m_b, b, middle, width);
        break;
    case Comparison::Difference:
        put(*m_a, tr("4 |A − B|, A: %1, B: now").arg(kept->name), 0, width);
        put(*m_b, {}, 0, width);
        break;
    }
    const bool isMeasured = comparison != Comparison::Off && comparison != Comparison::Hold;
    put(*m_figures, isMeasured ? errorText(m_snapshots.error()) : QString(), 0, width);
    m_figures->move(margin, 2 * margin + m_a->sizeHint().height() - 4);
}

bool ComparisonLabels::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        follow();
    return QObject::eventFilter(watched, event);
}

} // namespace mirrorball::studio
