#pragma once

#include <QPolygonF>
#include <QWidget>

namespace mirrorball::studio {

/// An outline over the preview where the brush would paint on the model.
class BrushRing : public QWidget {
    Q_OBJECT

public:
    explicit BrushRing(QWidget& over);

    const QPolygonF& outline() const { return m_outline; }
    /// @param outline  in the widget's coordinates; empty: none. @param note  what stands below it
    void show(const QPolygonF& outline, const QString& note = {});

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QPolygonF m_outline;
    QString m_note;
};

} // namespace mirrorball::studio
