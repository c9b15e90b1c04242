#pragma once

#include <QScrollArea>

namespace mirrorball::studio {

/// What a dock shows of its panel: all of it where there is room, else a part that can be scrolled. So a panel that comes to need more -
/// another row, a second view - changes neither its dock nor the window, and on a small screen nothing is cut.
class DockScroll : public QScrollArea {
public:
    /// @param panel  becomes a child
    explicit DockScroll(QWidget& panel)
    {
        setFrameShape(QFrame::NoFrame);
        setWidgetResizable(true);
        setFocusPolicy(Qt::NoFocus);
        setWidget(&panel);
    }
    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override { return {160, 96}; }
};

} // namespace mirrorball::studio
