#include "levels_view.h"

#include "widgets/picture/screen_picture.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {
constexpr int largestPicture = 512, smallestPicture = 16;
constexpr double margin = 8.0, gap = 6.0;
} // namespace

LevelsView::LevelsView(SphereMapEditor& editor, QWidget* parent) : QWidget(parent), m_editor(editor)
{
    setObjectName(QStringLiteral("levelsView"));
    setAccessibleName(tr("Levels of the mip chain"));
    setFocusPolicy(Qt::StrongFocus);
    m_rest.setSingleShot(true);
    m_rest.setInterval(150);
    connect(&m_rest, &QTimer::timeout, this, &LevelsView::request);
    connect(&m_editor, &SphereMapEditor::mapChanged, this, [this] {
        m_isStale = true;
        if (isVisible())
            m_rest.start();
    });
    connect(&m_editor, &SphereMapEditor::onlyLevelChanged, this, [this] {
        setAccessibleDescription(m_editor.onlyLevelText());
        update();
    });
    connect(&m_runner, &JobRunner::failed, this, [this](const QString& message) {
        m_problem = message;
        update();
    });
}

void LevelsView::showEvent(QShowEvent*)
{
    if (m_isStale)
        m_rest.start();
}

void LevelsView::request()
{
    m_isStale = false;
    if (!m_editor.map()) {
        m_levels.clear();
        update();
        return;
    }
    m_isAuthored = hasAuthoredLevels(*m_editor.map());
    m_runner.start(
        [map = *m_editor.map(), size = m_editor.size()](const JobControl& job) {
            QVector<Level> levels;
            for (const Image& level : evaluateLevels(map, {.size = size, .unknownLayers = UnknownLayers::Skip}, job)) {
                levels << Level{.size = level.width};
                for (const Image& halved : plainChain(level, job))
                    if (halved.width <= largestPicture && (halved.width >= smallestPicture || halved.width == level.width))
                        levels.last().pictures << onScreen(halved, job);
            }
            return levels;
        },
        [this](const QVector<Level>& levels) {
            m_levels = levels;
            m_problem.clear();
            update();
            emit updated();
        });
}

QString LevelsView::note() const
{
    return m_isAuthored ? tr("Made level by level: a layer has its width in pixels, or levels of its own. Click a level to paint it alone.")
                        : tr("Each level averages the one above. Click a level to paint it alone; a layer with a width in pixels is made "
                             "for each, too.");
}

QRect LevelsView::noteArea() const
{
    return fontMetrics().boundingRect(rect().adjusted(8, 8, -8, -8), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, note());
}

/// In as many columns as give the largest cells.
QRectF LevelsView::cell(int level) const
{
    const int top = noteArea().bottom() + 8, label = fontMetrics().height() + 4, count = static_cast<int>(m_levels.size());
    int columns = 1;
    double edge = 0.0;
    for (int c = 1; c <= count; ++c) {
        const int rows = (count + c - 1) / c;
        const double fitting = std::min((width() - 2.0 * margin - gap * (c - 1)) / c, (height() - top - (label + gap) * rows) / rows);
        if (fitting > edge) {
            edge = fitting;
            columns = c;
        }
    }
    return {margin + level % columns * (edge + gap), top + level / columns * (edge + label + gap), edge, edge};
}

int LevelsView::levelAt(const QPointF& place) const
{
    for (int i = 0; i < static_cast<int>(m_levels.size()); ++i)
        if (cell(i).adjusted(0, 0, 0, fontMetrics().height()).contains(place))
            return i;
    return -1;
}

void LevelsView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::Text));
    if (!m_problem.isEmpty() || m_levels.isEmpty()) {
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         !m_problem.isEmpty() ? m_problem
                         : m_editor.map()     ? tr("Making the levels ...")
                                              : tr("No sphere map"));
        return;
    }
    painter.drawText(noteArea(), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, note());
    for (int i = 0; i < static_cast<int>(m_levels.size()); ++i) {
        const QRectF area = cell(i);
        const bool isShownAlone = m_editor.onlyLevel() == i;
        painter.fillRect(area, QColor(70, 70, 70));
        painter.drawImage(area, m_levels[i].forPixels(static_cast<int>(std::ceil(area.width() * devicePixelRatioF()))));
        if (isShownAlone) {
            painter.setPen(QPen(QColor(0xd8, 0xb0, 0x6c), 2.0));
            painter.drawRect(area);
        }
        painter.setPen(palette().color(isShownAlone ? QPalette::BrightText : QPalette::Text));
        painter.drawText(QRectF(area.left(), area.bottom() + 1.0, area.width(), fontMetrics().height() + 4),
                         Qt::AlignHCenter | Qt::AlignTop, tr("%1: %2").arg(i).arg(m_levels[i].size));
    }
}

void LevelsView::mousePressEvent(QMouseEvent* event)
{
    const int level = levelAt(event->position());
    if (level >= 0 && event->button() == Qt::LeftButton)
        m_editor.showOnly(m_editor.onlyLevel() == level ? std::nullopt : std::optional(level));
}

void LevelsView::keyPressEvent(QKeyEvent* event)
{
    const int last = static_cast<int>(m_levels.size()) - 1;
    const std::optional<int> now = m_editor.onlyLevel();
    if (event->key() == Qt::Key_Escape && now)
        m_editor.showOnly(std::nullopt);
    else if (event->key() == Qt::Key_Right && last >= 0)
        m_editor.showOnly(now ? std::min(*now + 1, last) : 0);
    else if (event->key() == Qt::Key_Left && last >= 0)
        m_editor.showOnly(now ? std::max(*now - 1, 0) : last);
    else
        QWidget::keyPressEvent(event);
}

bool LevelsView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && m_editor.onlyLevel())
        event->accept(); // before the shortcut that stops work
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int level = levelAt(help->pos());
    if (level < 0)
        QToolTip::hideText();
    else
        QToolTip::showText(help->globalPos(),
                           m_editor.onlyLevel() == level ? tr("Click or Escape: show all levels again")
                                                         : tr("Click: show and paint this level alone, on the disc and on the model"),
                           this);
    return true;
}

QImage LevelsView::Level::forPixels(int pixels) const
{
    if (pixels >= size)
        return pictures.front();
    int i = 0;
    while (i + 1 < static_cast<int>(pictures.size()) && pictures[i + 1].width() >= pixels)
        ++i;
    return pictures[i].scaled(pixels, pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation); // an average over less than 2 x 2
}

} // namespace mirrorball::studio
