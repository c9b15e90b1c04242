#pragma once

#include "picture_values.h"

#include "widgets/workspace/job_runner.h"

#include <QLabel>
#include <QWidget>

#include <optional>

namespace mirrorball::studio {

/// What of a picture is told in numbers.
enum class Inspect : unsigned {
    Values = 1,    ///< of the pixel under the mouse
    Histogram = 2, ///< of the display values
    Clipping = 4,  ///< marks where exposed light is above 1 or below 0
};
Q_DECLARE_FLAGS(Inspections, Inspect)
Q_DECLARE_OPERATORS_FOR_FLAGS(Inspections)

/// Red, green and blue over each other, each bin as high as the root of its count.
class HistogramView : public QWidget {
    Q_OBJECT

public:
    explicit HistogramView(QWidget* parent = nullptr);
    void show(const DisplayHistogram& histogram);
    const DisplayHistogram& histogram() const { return m_histogram; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    DisplayHistogram m_histogram{};
};

/// A box in the picture's corner that tells its numbers, and the marks of what is clipped. Light is drawn for it when the picture rests;
/// while nothing is inspected, nothing is drawn. The mouse goes through to the picture.
class PictureInspector : public QWidget {
    Q_OBJECT

public:
    PictureInspector(RenderThread& thread, QWidget& picture);

    Inspections inspections() const { return m_inspections; }
    void setInspections(Inspections inspections);
    /// What is shown, at rest: its light is asked for.
    void inspect(const PictureOrder& order);
    /// Something moves: there are no marks and no linear values until it rests.
    void wait();
    /// A new picture is shown.
    void setPicture(const Picture& picture);
    /// What the mouse points at. @param pixel  device pixel of the whole picture; nothing: not at it
    void point(const std::optional<QPoint>& pixel, const PickedPixel& picked);
    /// Over the picture; null where nothing is to be marked, or not known yet.
    const QImage& marks() const { return m_clipping.marks; }
    /// The text of a row: "pixel", "linear", "display", "direction", "level", "clipping".
    QString text(const QString& row) const;

signals:
    void marksChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addRow(const char* name, const QString& title);
    void setText(const char* row, const QString& text);
    bool needsLight() const { return m_inspections & (Inspections(Inspect::Values) | Inspect::Clipping); }
    void requestLight();
    void findClipping();
    void showValues();
    void place();

    RenderThread& m_thread;
    QWidget& m_picture;
    HistogramView* m_histogram;
    QWidget* m_values;
    Inspections m_inspections{};
    Picture m_shown{};
    std::optional<PictureOrder> m_resting{}; ///< what is shown, at rest
    std::optional<PictureOrder> m_lightOf{}; ///< what the light, or that which is on its way, is of
    LightPair m_light{};
    Clipping m_clipping{};
    std::optional<QPoint> m_pixel{};
    PickedPixel m_picked{};
    JobRunner m_counting, m_marking;
};

} // namespace mirrorball::studio
