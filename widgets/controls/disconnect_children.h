#pragma once

#include <QWidget>

namespace mirrorball::studio {

/// For destructors of widgets that listen to their children. A child that has the focus loses it when it is destroyed, and says so
/// (editingFinished), but that happens in ~QWidget, when the class that listens is gone.
inline void disconnectChildren(QWidget& parent)
{
    for (const QWidget* child : parent.findChildren<QWidget*>())
        QObject::disconnect(child, nullptr, &parent, nullptr);
}

} // namespace mirrorball::studio
