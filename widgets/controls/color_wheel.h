#pragma once

#include <QColor>
#include <QImage>
#include <QWidget>

namespace mirrorball::studio {

/// Hue around, saturation from the middle to the rim. Left drag chooses; arrow keys turn and move.
class ColorWheel : public QWidget {
    Q_OBJECT

public:
    explicit ColorWheel(QWidget* parent = nullptr);

    /// @param hue, saturation, value  in [0, 1]
    void setHsv(double hue, double saturation, double value);
    QSize sizeHint() const override { return {180, 180}; }
    QSize minimumSizeHint() const override { return {110, 110}; }

signals:
    void edited(double hue, double saturation);
    void finished();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF disc() const;
    void chooseAt(const QPointF& position);

    double m_hue = 0.0, m_saturation = 0.0, m_value = 1.0;
    QImage m_image{}; ///< of the disc at its size and value
    double m_imageValue = -1.0;
};

} // namespace mirrorball::studio
