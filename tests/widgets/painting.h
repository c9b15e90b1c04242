#pragma once

#include "studio_window.h"

#include "widgets/spheremap/sphere_map_panel.h"

#include <QDockWidget>
#include <QPointingDevice>
#include <QTabletEvent>

namespace mirrorball::test {

/// A window with the dock in front and a map of a ground and a paint layer.
class Painting {
public:
    explicit Painting(bool withMap = true)
    {
        m_window.show();
        QDockWidget* dock = m_window->dock(QStringLiteral("sphere-map"));
        dock->setFloating(true);
        dock->resize(380, 900);
        dock->show();
        dock->raise();
        m_panel = dock->findChild<studio::SphereMapPanel*>();
        if (withMap)
            QTest::mouseClick(m_panel->findChild<QWidget*>(QStringLiteral("newSphereMap")), Qt::LeftButton);
        waitForPicture();
        QTest::qWait(50);
    }

    StudioWindow& window() { return m_window; }
    studio::SphereMapPanel& panel() { return *m_panel; }
    studio::SphereMapCanvas& canvas() { return m_panel->canvas(); }
    studio::SphereMapEditor& editor() { return m_window->workspace().sphereMap; }
    studio::Document& document() { return m_window.document(); }
    int steps() { return document().undoStack().index(); }
    const std::vector<Stroke>& strokes(size_t layer = 1) { return std::get<PaintLayer>(editor().map()->layers[layer].content).strokes; }

    void waitForPicture() { QTRY_VERIFY_WITH_TIMEOUT(editor().isUpToDate(), 30000); }
    QPoint at(double x, double y) { return canvas().placeOf({x, y}).toPoint(); }
    void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {})
    {
        drag(&canvas(), from, to, button, keys);
    }
    static void drag(QWidget* widget, const QPoint& from, const QPoint& to, Qt::MouseButton button = Qt::LeftButton,
                     Qt::KeyboardModifiers keys = {})
    {
        QTest::mousePress(widget, button, keys, from);
        for (int i = 1; i <= 6; ++i) { // QTest::mouseMove moves without a button
            const QPointF place = QPointF(from) + QPointF(to - from) * (i / 6.0);
            QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, button, keys);
            QCoreApplication::sendEvent(widget, &move);
        }
        QTest::mouseRelease(widget, button, keys, to);
    }
    void pen(QEvent::Type type, const QPointF& place, double pressure, QPointingDevice::PointerType end, const QPointF& tiltDeg = {})
    {
        constexpr auto reports = QInputDevice::Capability::Position | QInputDevice::Capability::Pressure | QInputDevice::Capability::XTilt |
                                 QInputDevice::Capability::YTilt;
        static const QPointingDevice tip(QStringLiteral("pen"), 77, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                                         reports, 1, 2);
        static const QPointingDevice eraser(QStringLiteral("eraser"), 78, QInputDevice::DeviceType::Stylus,
                                            QPointingDevice::PointerType::Eraser, reports, 1, 2);
        const auto button = type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton;
        QTabletEvent event(type, end == QPointingDevice::PointerType::Eraser ? &eraser : &tip, place, canvas().mapToGlobal(place), pressure,
                           static_cast<float>(tiltDeg.x()), static_cast<float>(tiltDeg.y()), 0, 0, 0, {}, button,
                           type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
        QCoreApplication::sendEvent(&canvas(), &event);
    }

private:
    StudioWindow m_window;
    studio::SphereMapPanel* m_panel = nullptr;
};

} // namespace mirrorball::test
