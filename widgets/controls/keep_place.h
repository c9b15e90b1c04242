#pragma once

#include <QProgressBar>
#include <QWidget>

namespace mirrorball::studio {

/// Nothing beside it moves when it is hidden or shown.
inline void keepPlace(QWidget& widget)
{
    QSizePolicy policy = widget.sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget.setSizePolicy(policy);
}

/// A thin bar without words, which leaves its place empty while there is no work.
inline void makeSlim(QProgressBar& bar, int height = 4)
{
    bar.setTextVisible(false);
    bar.setMaximumHeight(height);
    keepPlace(bar);
}

} // namespace mirrorball::studio
