#pragma once

#include <QDockWidget>
#include <QEvent>
#include <QObject>
#include <QTimer>

namespace mirrorball::studio {

/// Hides a dock's panel while the dock stands behind another tab, so that the panel works for nobody.
///
/// Qt moves such a dock off the window and goes on to count it as visible; visibilityChanged() tells most of it, but not where a dock is
/// shown at its old place before the layout moves it. So the place is looked at, whenever it may have changed.
class PanelRest : public QObject {
public:
    /// @param dock that has its panel; becomes the owner
    explicit PanelRest(QDockWidget& dock) : QObject(&dock), m_dock(dock)
    {
        QSizePolicy keepsPlace = dock.widget()->sizePolicy();
        keepsPlace.setRetainSizeWhenHidden(true);
        dock.widget()->setSizePolicy(keepsPlace);
        m_soon.setSingleShot(true);
        connect(&m_soon, &QTimer::timeout, this, [this] { look(); });
        connect(&dock, &QDockWidget::visibilityChanged, &m_soon, qOverload<>(&QTimer::start));
        dock.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        switch (event->type()) {
        case QEvent::Show:
        case QEvent::Move:
        case QEvent::Resize:
        case QEvent::ParentChange:
            m_soon.start();
            break;
        default:
            break;
        }
        return QObject::eventFilter(watched, event);
    }

private:
    void look()
    {
        const QRect place = m_dock.geometry();
        m_dock.widget()->setVisible(m_dock.isFloating() || (place.right() >= 0 && place.bottom() >= 0));
    }

    QDockWidget& m_dock;
    QTimer m_soon; ///< at once, but after the layout's own events
};

} // namespace mirrorball::studio
