#pragma once

#include <QPushButton>

#include <glm/glm.hpp>

namespace mirrorball::studio {

/// A color as a swatch. A click hands it to the window's color picker, or opens a chooser where there is none; its menu copies and pastes.
/// Linear RGB outside, sRGB on the screen; what is brighter than a screen can show has its stops written on it.
class ColorButton : public QPushButton {
    Q_OBJECT

public:
    explicit ColorButton(QWidget* parent = nullptr);
    const glm::dvec3& color() const { return m_color; }
    void setColor(const glm::dvec3& linear);
    /// The user chose a color, elsewhere. More may follow until endPick().
    void pick(const glm::dvec3& linear);
    void endPick() { emit finished(); }

signals:
    void edited(const glm::dvec3& linear);
    void finished();
    /// color() is another, by whatever way.
    void colorChanged(const glm::dvec3& linear);

protected:
    void paintEvent(QPaintEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void choose();
    glm::dvec3 m_color{0.0};
};

} // namespace mirrorball::studio
