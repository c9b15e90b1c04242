#include "picture_inspector.h"

#include <QEvent>
#include <QFormLayout>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr int fromCorner = 8;   ///< pixels
constexpr int badgeHeight = 32; ///< of the badges in the other corner
constexpr int roomForBadges = 500;

QString vectorText(const glm::dvec3& v, int digits)
{
    QStringList numbers;
    for (int c = 0; c < 3; ++c)
        numbers << QString::number(v[c], 'f', digits);
    return numbers.join(QStringLiteral("  "));
}

/// Four digits that mean something: a sun's 52000 as well as the dark's 0.0001234.
QString lightText(const glm::vec3& light)
{
    QStringList numbers;
    for (int c = 0; c < 3; ++c)
        numbers << QString::number(static_cast<double>(light[c]), 'g', 4);
    return numbers.join(QStringLiteral("  "));
}

QString directionText(const glm::dvec3& d)
{
    const double degrees = 180.0 / pi;
    return QStringLiteral("%1  (%2°, %3°)")
        .arg(vectorText(d, 2))
        .arg(degrees * std::atan2(d.x, d.z), 0, 'f', 1)
        .arg(degrees * std::asin(std::clamp(d.y, -1.0, 1.0)), 0, 'f', 1);
}

} // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) { setFixedSize(256, 72); }

void HistogramView::show(const DisplayHistogram& histogram)
{
    m_histogram = histogram;
    update();
}

void HistogramView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), QColor(0x14, 0x14, 0x14));
    quint32 highest = 1; // a black or white background would flatten all else
    for (const auto& channel : m_histogram)
        highest = std::max(highest, *std::max_element(channel.begin() + 1, channel.end() - 1));
    painter.setCompositionMode(QPainter::CompositionMode_Plus);
    const QColor colors[] = {QColor(200, 50, 50), QColor(40, 170, 60), QColor(60, 90, 220)};
    for (size_t c = 0; c < 3; ++c)
        for (int i = 0; i < 256; ++i) {
            const double share = std::sqrt(static_cast<double>(m_histogram[c][static_cast<size_t>(i)]) / highest);
            const int high = static_cast<int>(std::lround(std::min(share, 1.0) * height()));
            painter.fillRect(i, height() - high, 1, high, colors[c]);
        }
}

PictureInspector::PictureInspector(RenderThread& thread, QWidget& picture)
    : QWidget(&picture), m_thread(thread), m_picture(picture), m_histogram(new HistogramView), m_values(new QWidget), m_counting(this),
      m_marking(this)
{
    setObjectName(QStringLiteral("inspector"));
    setProperty("role", QStringLiteral("pictureLabel"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_StyledBackground);
    m_histogram->setObjectName(QStringLiteral("inspector.histogram"));
    m_histogram->setAccessibleName(tr("Histogram of the display values"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 6);
    column->setSpacing(4);
    column->setSizeConstraint(QLayout::SetFixedSize);
    column->addWidget(m_histogram);
    auto* clipping = new QLabel;
    clipping->setObjectName(QStringLiteral("inspector.clipping"));
    column->addWidget(clipping);
    column->addWidget(m_values);
    auto* rows = new QFormLayout(m_values);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setVerticalSpacing(1);
    addRow("pixel", tr("pixel"));
    addRow("linear", tr("linear"));
    addRow("display", tr("display"));
    addRow("direction", tr("direction"));
    addRow("level", tr("level"));
    m_picture.installEventFilter(this);
    installEventFilter(this); // another text may need another width
    setInspections({});
}

void PictureInspector::addRow(const char* name, const QString& title)
{
    auto* value = new QLabel;
    value->setObjectName(QStringLiteral("inspector.") + QLatin1String(name));
    value->setAccessibleName(title);
    value->setMinimumWidth(
        value->fontMetrics().horizontalAdvance(QStringLiteral("−0.00  −0.00  −0.00  (−180.0°, −90.0°)"))); // stays as wide
    static_cast<QFormLayout*>(m_values->layout())->addRow(title, value);
}

QString PictureInspector::text(const QString& row) const
{
    const auto* label = findChild<QLabel*>(QStringLiteral("inspector.") + row);
    return label ? label->text() : QString();
}

void PictureInspector::setText(const char* row, const QString& text)
{
    findChild<QLabel*>(QStringLiteral("inspector.") + QLatin1String(row))->setText(text.isEmpty() ? QStringLiteral("–") : text);
}

void PictureInspector::setInspections(Inspections inspections)
{
    m_inspections = inspections;
    setVisible(inspections != Inspections());
    m_histogram->setVisible(inspections.testFlag(Inspect::Histogram));
    findChild<QLabel*>(QStringLiteral("inspector.clipping"))->setVisible(inspections.testFlag(Inspect::Clipping));
    m_values->setVisible(inspections.testFlag(Inspect::Values));
    setPicture(m_shown);
    requestLight();
    findClipping();
    showValues();
    place();
}

void PictureInspector::inspect(const PictureOrder& order)
{
    PictureOrder resting = order;
    resting.number = 0;
    resting.settings.marker.reset(); // stands over the light
    resting.snapshotSettings.marker.reset();
    if (m_resting == resting)
        return;
    m_resting = std::move(resting);
    requestLight();
}

void PictureInspector::wait()
{
    if (!m_resting)
        return;
    m_resting.reset();
    m_lightOf.reset();
    m_light = {};
    findClipping();
    showValues();
}

// What only the eye adds - exposure, where the wipe stands - needs no new light.
void PictureInspector::requestLight()
{
    if (!m_resting || !needsLight())
        return;
    const auto lightOnly = [](PictureOrder order) {
        order.settings.exposure = order.snapshotSettings.exposure = 0.0f;
        order.settings.display = order.snapshotSettings.display = nullptr;
        order.wipe = 0;
        order.size = {};
        order.comparison = order.snapshot ? Comparison::Wipe : Comparison::Off;
        return order;
    };
    if (m_lightOf && *m_lightOf == lightOnly(*m_resting)) {
        findClipping();
        showValues();
        return;
    }
    m_lightOf = lightOnly(*m_resting);
    m_light = {};
    m_thread.drawLight(*m_lightOf, [this, of = *m_lightOf](const LightPair& light) {
        if (of != m_lightOf)
            return; // something else is shown by now
        m_light = light;
        findClipping();
        showValues();
    });
}

void PictureInspector::findClipping()
{
    const bool isKnown = m_resting && !m_light.now.empty() && m_inspections.testFlag(Inspect::Clipping);
    if (!isKnown) {
        m_marking.stop();
        m_clipping = {};
        setText("clipping", tr("clipped: looking…"));
        emit marksChanged();
        return;
    }
    m_marking.start([light = m_light, order = *m_resting](const JobControl&) { return clippingOf(light, order); },
                    [this](const Clipping& clipping) {
                        m_clipping = clipping;
                        const auto share = [](double s) { return QString::number(100.0 * s, 'f', s > 0.0 && s < 1e-3 ? 3 : 1); };
                        setText("clipping", tr("%1 % above 1, %2 % below 0").arg(share(clipping.above), share(clipping.below)));
                        emit marksChanged();
                    });
}

void PictureInspector::setPicture(const Picture& picture)
{
    m_shown = picture;
    if (m_inspections.testFlag(Inspect::Histogram) && !picture.image.isNull())
        m_counting.start([image = picture.image](const JobControl&) { return histogramOf(image); },
                         [this](const DisplayHistogram& histogram) { m_histogram->show(histogram); }, Running::Finish);
    showValues();
}

void PictureInspector::point(const std::optional<QPoint>& pixel, const PickedPixel& picked)
{
    m_pixel = pixel;
    m_picked = picked;
    showValues();
}

void PictureInspector::showValues()
{
    if (!m_inspections.testFlag(Inspect::Values))
        return;
    for (const char* row : {"pixel", "linear", "display", "direction", "level"})
        setText(row, {});
    if (!m_pixel || !m_shown.image.rect().contains(*m_pixel))
        return;
    const PictureOrder& order = m_shown.order;
    setText("pixel", QStringLiteral("%1, %2").arg(m_pixel->x()).arg(m_pixel->y()));
    const QColor color = m_shown.image.pixelColor(*m_pixel);
    setText("display", QStringLiteral("%1  %2  %3  %4").arg(color.red()).arg(color.green()).arg(color.blue()).arg(color.name()));
    if (const auto light = m_resting ? lightAt(m_light, *m_resting, *m_pixel) : std::nullopt)
        setText("linear", lightText(*light));
    const auto at = scenePixel(order, *m_pixel);
    if (!at)
        return;
    // The model was asked for what it shows now; the snapshot's may be another.
    const preview::RenderSettings& settings = at->isKept ? order.snapshotSettings : order.settings;
    const bool isAsked = !at->isKept || order.snapshotSettings.geometry == order.settings.geometry;
    if (m_picked.hit && isAsked)
        setText("direction", directionText(glm::dvec3(m_picked.hit->lookup)));
    else if (!m_picked.hit && isAsked && isEnvironment(settings.background.kind))
        setText("direction", directionText(backgroundDirection(settings, at->pixel)));
    if (m_picked.level && !at->isKept)
        setText("level", QString::number(static_cast<double>(*m_picked.level), 'f', 2));
}

void PictureInspector::place()
{
    layout()->activate();
    const int below = m_picture.width() < roomForBadges ? badgeHeight : 0;
    move(std::max(0, m_picture.width() - width() - fromCorner), std::max(0, m_picture.height() - height() - fromCorner - below));
}

bool PictureInspector::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

} // namespace mirrorball::studio
