#pragma once

#include "app/studio/main_window.h"
#include "app/studio/theme.h"
#include "patience.h"
#include "support/temporary_folder.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTest>

namespace mirrorball::test {

/// A real window with a recovery folder of its own, shown and drawn.
class StudioWindow {
public:
    StudioWindow() : m_window(std::make_unique<studio::MainWindow>(QString::fromStdString(m_folder.path().string()))) {}
    ~StudioWindow()
    {
        m_window->workspace().document.reset(); // nothing unsaved: no question
    }

    studio::MainWindow& operator*() { return *m_window; }
    studio::MainWindow* operator->() { return m_window.get(); }
    studio::Document& document() { return m_window->workspace().document; }
    studio::PreviewWidget& preview() { return m_window->preview(); }

    void show()
    {
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QApplication::setActiveWindow(m_window.get()); // there is no window manager that would
        waitForPicture();
    }
    /// Until maps and picture are of the document's scene.
    void waitForPicture()
    {
        QTRY_VERIFY_WITH_TIMEOUT(m_window->workspace().live.isUpToDate(), patience);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->preview().isUpToDate(), patience);
    }
    QImage picture()
    {
        waitForPicture();
        QImage picture = m_window->preview().picture().convertToFormat(QImage::Format_RGB888);
        picture.setDevicePixelRatio(1.0);
        return picture;
    }

private:
    TemporaryFolder m_folder;
    std::unique_ptr<studio::MainWindow> m_window;
};

/// The largest difference of any channel of two pictures of one size; 256 for different sizes.
inline int largestDifference(const QImage& a, const QImage& b)
{
    if (a.size() != b.size())
        return 256;
    int largest = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            largest = std::max({largest, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    return largest;
}

} // namespace mirrorball::test
