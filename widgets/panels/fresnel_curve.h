#pragma once

#include "widgets/workspace/document.h"

#include <QWidget>

namespace mirrorball::studio {

/// F over the angle between view and normal, of the document's material: one curve, or one a channel for a metal. Reads out the values
/// under the mouse.
class FresnelCurve : public QWidget {
    Q_OBJECT

public:
    explicit FresnelCurve(Document& document, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {260, 150}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QRectF plotArea() const;

    Document& m_document;
    double m_angle = -1.0; ///< degrees under the mouse; negative: none
};

} // namespace mirrorball::studio
