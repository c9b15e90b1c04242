#pragma once

#include <QLineF>
#include <QPainter>
#include <QPolygonF>
#include <QWidget>

namespace mirrorball::studio {

/// The line from a brush that hangs back to the pointer that pulls it, light and dark, so that it shows on every color.
void paintString(QPainter& painter, const QLineF& string);

/// An outline over the preview where the brush would paint on the model.
class BrushRing : public QWidget {
    Q_OBJECT

public:
    explicit BrushRing(QWidget& over);

    const QPolygonF& outline() const { return m_outline; }
    /// @param outline  in the widget's coordinates; empty: none. @param note  what stands below it
    /// @param string  from the brush to the pointer, where they are apart
    void show(const QPolygonF& outline, const QString& note = {}, const QLineF& string = {});

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QPolygonF m_outline;
    QString m_note;
    QLineF m_string;
};

} // namespace mirrorball::studio
