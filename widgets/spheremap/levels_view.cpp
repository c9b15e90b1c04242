#include "levels_view.h"

#include "widgets/picture/screen_picture.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {
constexpr int largestPicture = 512;
constexpr double margin = 8.0, gap = 6.0;
} // namespace

LevelsView::LevelsView(SphereMapEditor& editor, QWidget* parent) : QWidget(parent), m_editor(editor)
{
    setObjectName(QStringLiteral("levelsView"));
    setAccessibleName(tr("Levels of the mip chain"));
    m_rest.setSingleShot(true);
    m_rest.setInterval(150);
    connect(&m_rest, &QTimer::timeout, this, &LevelsView::request);
    connect(&m_editor, &SphereMapEditor::mapChanged, this, [this] {
        m_isStale = true;
        if (isVisible())
            m_rest.start();
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
                QImage picture = onScreen(level, job);
                if (level.width > largestPicture)
                    picture = picture.scaled(largestPicture, largestPicture, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
                levels << Level{level.width, picture};
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
    const QString note = m_isAuthored ? tr("Made level by level: a layer has its width in pixels, or levels of its own.")
                                      : tr("Each level averages the one above. Give a layer a width in pixels to author them.");
    const QRect noteArea = painter.boundingRect(rect().adjusted(8, 8, -8, -8), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, note);
    painter.drawText(noteArea, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, note);
    const int top = noteArea.bottom() + 8, label = fontMetrics().height() + 4;
    // As many columns as give the largest cells.
    const int count = static_cast<int>(m_levels.size());
    int columns = 1;
    double cell = 0.0;
    for (int c = 1; c <= count; ++c) {
        const int rows = (count + c - 1) / c;
        const double edge = std::min((width() - 2.0 * margin - gap * (c - 1)) / c, (height() - top - (label + gap) * rows) / rows);
        if (edge > cell) {
            cell = edge;
            columns = c;
        }
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < count; ++i) {
        const QRectF area(margin + i % columns * (cell + gap), top + i / columns * (cell + label + gap), cell, cell);
        painter.fillRect(area, QColor(70, 70, 70));
        painter.setRenderHint(QPainter::SmoothPixmapTransform, m_levels[i].picture.width() > cell * devicePixelRatioF());
        painter.drawImage(area, m_levels[i].picture);
        painter.drawText(QRectF(area.left(), area.bottom() + 1.0, cell, label), Qt::AlignHCenter | Qt::AlignTop,
                         tr("%1: %2").arg(i).arg(m_levels[i].size));
    }
}

} // namespace mirrorball::studio
