#include "main_window_test.h"

#include "app/studio/main_window.h"

#include <QSignalSpy>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<MainWindowTest> registered;

void MainWindowTest::showsThePictureThatTheCommandLineDraws()
{
    MainWindow window;
    QSignalSpy painted(&window.preview(), &PreviewWidget::painted);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QTRY_VERIFY_WITH_TIMEOUT(!painted.isEmpty(), 20000);
    const QImage picture = window.preview().grabFramebuffer();
    QVERIFY(!picture.isNull());
    QVERIFY2(window.preview().problem().isEmpty(), qPrintable(window.preview().problem()));
}

} // namespace mirrorball::test
