#include "preview_widget_test.h"

#include "studio_window.h"

#include <QAction>
#include <QWheelEvent>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<PreviewWidgetTest> registered;

static void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::MouseButtons held,
                      Qt::KeyboardModifiers keys)
{
    QMouseEvent event(type, at, widget.mapToGlobal(at), button, held, keys);
    QApplication::sendEvent(&widget, &event);
}

static void drag(QWidget& widget, const QPointF& from, const QPointF& to, Qt::MouseButton button, Qt::KeyboardModifiers keys = {})
{
    sendMouse(widget, QEvent::MouseButtonPress, from, button, button, keys);
    for (int i = 1; i <= 8; ++i)
        sendMouse(widget, QEvent::MouseMove, from + (to - from) * (i / 8.0), Qt::NoButton, button, keys);
    sendMouse(widget, QEvent::MouseButtonRelease, to, button, {}, keys);
}

void PreviewWidgetTest::aDragIsOneStep_data()
{
    QTest::addColumn<int>("button");
    QTest::addColumn<int>("keys");
    QTest::addColumn<QString>("label");
    QTest::newRow("left orbits") << int(Qt::LeftButton) << int(Qt::NoModifier) << QStringLiteral("Orbit");
    QTest::newRow("middle pans") << int(Qt::MiddleButton) << int(Qt::NoModifier) << QStringLiteral("Pan");
    QTest::newRow("shift and right turn the light")
        << int(Qt::RightButton) << int(Qt::ShiftModifier) << QStringLiteral("Turn the environment");
}

void PreviewWidgetTest::aDragIsOneStep()
{
    QFETCH(int, button);
    QFETCH(int, keys);
    QFETCH(QString, label);
    StudioWindow window;
    window.show();
    const QImage before = window.picture();
    drag(window.preview(), {100, 100}, {160, 120}, static_cast<Qt::MouseButton>(button), Qt::KeyboardModifiers(keys));
    QCOMPARE(window.document().undoStack().count(), 1);
    QCOMPARE(window.document().undoStack().undoText(), label);
    QVERIFY(!window.document().isDragging());
    QVERIFY(largestDifference(window.picture(), before) > 20);
    window.document().undoStack().undo();
    QVERIFY(window.document().scene() == newScene());
    QVERIFY(largestDifference(window.picture(), before) <= 1);
}

void PreviewWidgetTest::theGestureThatTurnsTheEnvironmentCanBeChosen()
{
    const struct {
        const char* action;
        Qt::MouseButton button;
        Qt::KeyboardModifier key;
    } gestures[] = {{"turn.control-left", Qt::LeftButton, Qt::ControlModifier},
                    {"turn.control-middle", Qt::MiddleButton, Qt::ControlModifier},
                    {"turn.shift-right", Qt::RightButton, Qt::ShiftModifier}};
    for (const auto& gesture : gestures) {
        {
            StudioWindow chosen;
            chosen->findChild<QAction*>(QLatin1String(gesture.action))->trigger();
        }
        StudioWindow window; // the next run knows
        window.show();
        drag(window.preview(), {100, 100}, {160, 100}, gesture.button, gesture.key);
        QCOMPARE(window.document().undoStack().undoText(), QStringLiteral("Turn the environment"));
        QVERIFY(window.document().scene().view.camera == CameraSettings{});
        drag(window.preview(), {100, 100}, {160, 100}, Qt::LeftButton);
        QCOMPARE(window.document().undoStack().undoText(), QStringLiteral("Orbit"));
    }
}

void PreviewWidgetTest::theWheelZooms()
{
    StudioWindow window;
    window.show();
    for (int i = 0; i < 3; ++i) {
        QWheelEvent event({50, 50}, window.preview().mapToGlobal(QPointF(50, 50)), {}, {0, 120}, {}, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&window.preview(), &event);
    }
    QVERIFY(window.document().scene().view.camera.distance < Scene{}.view.camera.distance);
    QTRY_VERIFY(!window.document().isDragging());
    QCOMPARE(window.document().undoStack().count(), 1);
}

void PreviewWidgetTest::keysFrameResetAndExpose()
{
    StudioWindow window;
    window.show();
    QTest::keyClick(&window.preview(), Qt::Key_E);
    QCOMPARE(window.document().scene().view.exposure, 0.5);
    QTRY_VERIFY(!window.document().isDragging());
    QTest::keyClick(&window.preview(), Qt::Key_E, Qt::ShiftModifier);
    QTRY_VERIFY(!window.document().isDragging());
    QCOMPARE(window.document().scene().view.exposure, 0.0);
    QCOMPARE(window.document().undoStack().count(), 2);
    window.document().edit(QStringLiteral("away"), {}, [](Scene& scene) {
        scene.view.camera.target = {1, 2, 3};
        scene.view.camera.yawDeg = 77;
    });
    QTest::keyClick(&window.preview(), Qt::Key_F);
    QVERIFY(window.document().scene().view.camera.target == glm::dvec3(0.0));
    QCOMPARE(window.document().scene().view.camera.yawDeg, 77.0);
    QTest::keyClick(&window.preview(), Qt::Key_R);
    QVERIFY(window.document().scene().view.camera == CameraSettings{});
}

void PreviewWidgetTest::comparesWithASnapshot()
{
    StudioWindow window;
    window.show();
    PreviewWidget& preview = window.preview();
    preview.setComparison(Comparison::Wipe);
    QCOMPARE(preview.comparison(), Comparison::Off); // nothing to compare with
    const QImage first = window.picture();
    preview.takeSnapshot();
    preview.setComparison(Comparison::Difference);
    const QImage black = window.picture();
    QVERIFY(largestDifference(black, QImage(black.size(), QImage::Format_RGB888)) >= 0);
    QImage nothing(black.size(), QImage::Format_RGB888);
    nothing.fill(Qt::black);
    QCOMPARE(largestDifference(black, nothing), 0);

    window.document().edit(QStringLiteral("gold"), {}, [](Scene& scene) { scene.material.fresnel = {.kind = FresnelKind::Conductor}; });
    preview.setComparison(Comparison::Off);
    const QImage second = window.picture();
    QVERIFY(largestDifference(first, second) > 20);
    preview.setComparison(Comparison::Wipe);
    preview.setWipe(0.5);
    const QImage wiped = window.picture();
    const int half = first.width() / 2 - 4;
    QVERIFY(largestDifference(wiped.copy(0, 0, half, first.height()), first.copy(0, 0, half, first.height())) <= 1);
    const QRect right(first.width() - half, 0, half, first.height());
    QVERIFY(largestDifference(wiped.copy(right), second.copy(right)) <= 1);
    const QPointF line(0.5 * preview.width(), 40);
    drag(preview, line, line + QPointF(100, 0), Qt::LeftButton);
    QVERIFY(std::abs(preview.wipe() - 0.5 - 100.0 / preview.width()) < 0.01);
    QCOMPARE(window.document().undoStack().count(), 1); // the wipe is no edit, and no orbit either

    preview.setComparison(Comparison::Off);
    QTest::keyPress(&preview, Qt::Key_B);
    QVERIFY(largestDifference(window.picture(), first) <= 1);
    QTest::keyRelease(&preview, Qt::Key_B);
    QVERIFY(largestDifference(window.picture(), second) <= 1);
}

// In the middle of a sphere seen from +Z the mirror shows what lies behind the eye: +Z.
void PreviewWidgetTest::theModelPointsIntoTheMap()
{
    StudioWindow window;
    window.document().edit(QStringLiteral("sphere"), {}, [](Scene& scene) {
        scene.view.geometry = "sphere";
        scene.view.camera.yawDeg = scene.view.camera.pitchDeg = 0.0;
    });
    window.show();
    QTest::mouseMove(&window.preview(), window.preview().rect().center() + QPoint(3, 3));
    QTest::mouseMove(&window.preview(), window.preview().rect().center());
    QTRY_VERIFY(window->workspace().cursor.direction().has_value());
    QTRY_VERIFY(window->workspace().cursor.direction()->z > 0.99);
}

} // namespace mirrorball::test
