#pragma once

#include <QScrollArea>

namespace mirrorball::studio {

/// A column of controls that scrolls up and down where it is higher than its place, and is as wide as that.
inline QScrollArea* scrolled(QWidget* inside)
{
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(inside);
    return scroll;
}

} // namespace mirrorball::studio
