#include "app/studio/main_window.h"
#include "app/studio/theme.h"
#include "widgets/number_field.h"
#include "widgets/options_form.h"

#include <QApplication>
#include <QEventLoop>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <vector>

/// From slider to picture: 200 steps of the exponent over its slider's whole range, 0.1 to 1e6, while it is dragged, in a real window
/// whose picture has 1280 x 720 pixels. A step lasts from the slider's move until the display has taken a picture with that exponent.
/// While something is dragged the studio draws one sample a pixel; the same is measured with the four of a picture at rest. Prints the
/// median and the slowest, the longest that any one event kept the GUI thread, and the time from the start of the process to the first
/// picture.
///
///   xvfb-run -a -s "-screen 0 1920x1200x24" build/ci/bin/studio_benchmark [PROBE [STEPS]]
namespace mirrorball::studio {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Processor time of the whole process or of this thread, in milliseconds: what a busy machine does not stretch.
double cpuMilliseconds(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// Watches how long each event keeps the thread.
class WatchedApplication : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override
    {
        if (m_depth++ > 0) {
            const bool done = QApplication::notify(receiver, event);
            --m_depth;
            return done;
        }
        const auto start = Clock::now();
        const bool done = QApplication::notify(receiver, event);
        longest = std::max(longest, millisecondsSince(start));
        --m_depth;
        return done;
    }
    double longest = 0.0;

private:
    int m_depth = 0;
};

/// Waits for pictures. @return false when none came for a minute
template <typename Done>
bool waitUntil(PreviewWidget& preview, Done done)
{
    QEventLoop loop;
    QTimer::singleShot(60000, &loop, [&] { loop.exit(1); });
    QObject::connect(&preview, &PreviewWidget::painted, &loop, [&](const std::shared_ptr<const PreparedScene>& made) {
        if (done(*made))
            QTimer::singleShot(0, &loop, [&] { loop.exit(0); }); // once the paint event is through and the window has been flushed
    });
    const bool isDone = loop.exec() == 0;
    QGuiApplication::sync(); // the display has taken the picture
    return isDone;
}

double percentile(std::vector<double> values, double fraction)
{
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<size_t>(fraction * static_cast<double>(values.size())))];
}

/// @return false when a picture did not come
bool dragExponent(MainWindow& window, WatchedApplication& application, int steps, int samples)
{
    PreviewWidget& preview = window.preview();
    preview.setSamplesWhileDragging(samples);
    const Document& document = window.workspace().document;
    QSlider* slider = window.findChild<NumberField*>(QStringLiteral("material.specular.exponent"))->slider();
    slider->setSliderDown(true);
    application.longest = 0.0;
    const double processBefore = cpuMilliseconds(CLOCK_PROCESS_CPUTIME_ID), threadBefore = cpuMilliseconds(CLOCK_THREAD_CPUTIME_ID);
    std::vector<double> latencies;
    for (int i = 0; i <= steps; ++i) {
        const auto moved = Clock::now();
        slider->setSliderPosition(slider->maximum() * i / steps);
        const double value = document.scene().material.specular.exponent;
        if (!waitUntil(preview, [&](const PreparedScene& made) { return made.scene.material.specular.exponent == value; }))
            return false;
        if (i > 0) // the first builds what a drag needs
            latencies.push_back(millisecondsSince(moved));
    }
    const double longest = application.longest;
    const double process = (cpuMilliseconds(CLOCK_PROCESS_CPUTIME_ID) - processBefore) / (steps + 1);
    const double thread = (cpuMilliseconds(CLOCK_THREAD_CPUTIME_ID) - threadBefore) / (steps + 1);
    slider->setSliderDown(false);
    std::printf("%d sample%s a pixel while dragging\n", samples, samples == 1 ? "" : "s");
    std::printf("  slider to picture, median  %7.1f ms\n", percentile(latencies, 0.5));
    std::printf("  slider to picture, 95 %%    %7.1f ms\n", percentile(latencies, 0.95));
    std::printf("  slider to picture, slowest %7.1f ms\n", percentile(latencies, 1.0));
    std::printf("  GUI thread busy at a time  %7.1f ms at most\n", longest);
    std::printf("  processor time of a step   %7.1f ms, of it GUI thread %.1f ms\n", process, thread);
    return true;
}

int run(WatchedApplication& application, Clock::time_point start)
{
    applyTheme(application);
    const QTemporaryDir folder;
    MainWindow window(folder.path());
    PreviewWidget& preview = window.preview();
    window.show();
    const bool began = waitUntil(preview, [](const PreparedScene&) { return true; });
    std::printf("start to first picture       %7.0f ms\n", millisecondsSince(start));
    const QStringList arguments = QCoreApplication::arguments();
    Document& document = window.workspace().document;
    document.edit(QStringLiteral("scene"), {}, [&](Scene& scene) {
        if (arguments.size() > 1)
            scene.probe.source = arguments[1].toStdString();
        scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50};
    });
    window.resize(window.size() + QSize(1280, 720) - preview.size());
    if (!began || !waitUntil(preview, [&](const PreparedScene& made) { return made.detail == MapDetail{} && made.scene == document.scene(); }))
        return 1;
    std::printf("picture                      %d x %d\n", preview.width(), preview.height());
    const int steps = arguments.size() > 2 ? std::max(1, arguments[2].toInt()) : 200;
    const bool isDone = dragExponent(window, application, steps, 1) && dragExponent(window, application, steps, 4);
    document.reset();
    return isDone ? 0 : 1;
}

} // namespace
} // namespace mirrorball::studio

int main(int count, char** arguments)
{
    const auto start = std::chrono::steady_clock::now();
    QStandardPaths::setTestModeEnabled(true);
    mirrorball::studio::WatchedApplication application(count, arguments);
    QCoreApplication::setOrganizationName(QStringLiteral("mirrorball-benchmark"));
    return mirrorball::studio::run(application, start);
}
