#pragma once

#include <QLabel>

#include <functional>
#include <utility>

namespace mirrorball::studio {

/// The label of a field, which resets it by a double click, as a number's slider does.
class FieldLabel : public QLabel {
public:
    explicit FieldLabel(const QString& text) : QLabel(text) {}
    void setReset(std::function<void()> reset) { m_reset = std::move(reset); }

protected:
    void mouseDoubleClickEvent(QMouseEvent*) override
    {
        if (m_reset)
            m_reset();
    }

private:
    std::function<void()> m_reset{};
};

} // namespace mirrorball::studio
