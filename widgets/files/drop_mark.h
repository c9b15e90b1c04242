#pragma once

#include <QString>
#include <QWidget>

namespace mirrorball::studio {

/// Lies over a widget while something is dragged across the window: says what a drop there does.
class DropMark : public QWidget {
    Q_OBJECT

public:
    /// @param over  what it lies over; becomes the owner
    explicit DropMark(QWidget& over);

    enum class Light { Dim, Bright };
    void showText(const QString& text, Light light);
    const QString& text() const { return m_text; }
    bool isBright() const { return m_light == Light::Bright; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_text;
    Light m_light = Light::Dim;
};

} // namespace mirrorball::studio
