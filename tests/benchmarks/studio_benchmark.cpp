#include "app/studio/main_window.h"
#include "app/studio/theme.h"
#include "widgets/number_field.h"
#include "widgets/options_form.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <vector>

/// From slider to picture: 200 steps of the exponent over its slider's whole range, 0.1 to 1e6, while it is dragged, in a real window
/// whose picture has 1280 x 720 pixels. A step lasts from the slider's move until a picture with that exponent was handed to the
/// display. Prints the median and the slowest, the longest that any one event kept the GUI thread, and the time from the start of the
/// process to the first picture.
///
///   xvfb-run -a -s "-screen 0 1920x1200x24" build/ci/bin/studio_benchmark [PROBE]
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
    std::shared_ptr<const PreparedScene> drawn;
    QObject::connect(&preview, &PreviewWidget::painted, &loop, [&](std::shared_ptr<const PreparedScene> made, double) { drawn = std::move(made); });
    QObject::connect(&preview, &QOpenGLWidget::frameSwapped, &loop, [&] {
        if (drawn && done(*drawn))
            loop.exit(0);
    });
    return loop.exec() == 0;
}

double percentile(std::vector<double> values, double fraction)
{
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<size_t>(fraction * static_cast<double>(values.size())))];
}

int run(WatchedApplication& application, Clock::time_point start)
{
    applyTheme(application);
    const QTemporaryDir folder;
    MainWindow window(folder.path());
    PreviewWidget& preview = window.preview();
    window.show();
    const bool began = waitUntil(preview, [](const PreparedScene&) { return true; });
    const double first = millisecondsSince(start);
    Document& document = window.workspace().document;
    document.edit(QStringLiteral("scene"), {}, [&](Scene& scene) {
        if (QCoreApplication::arguments().size() > 1)
            scene.probe.source = QCoreApplication::arguments()[1].toStdString();
        scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50};
    });
    window.resize(window.size() + QSize(1280, 720) - preview.size());
    if (!began || !waitUntil(preview, [&](const PreparedScene& made) { return made.detail == MapDetail{} && made.scene == document.scene(); }))
        return 1;

    auto* exponent = window.findChild<NumberField*>(QStringLiteral("material.specular.exponent"));
    QSlider* slider = exponent->slider();
    slider->setSliderDown(true);
    constexpr int steps = 200;
    std::vector<double> latencies;
    double processBefore = 0.0, threadBefore = 0.0;
    for (int i = 0; i <= steps; ++i) {
        if (i == 1) { // the first builds what a drag needs
            application.longest = 0.0;
            processBefore = cpuMilliseconds(CLOCK_PROCESS_CPUTIME_ID);
            threadBefore = cpuMilliseconds(CLOCK_THREAD_CPUTIME_ID);
        }
        const auto moved = Clock::now();
        slider->setSliderPosition(slider->maximum() * i / steps);
        const double value = document.scene().material.specular.exponent;
        if (!waitUntil(preview, [&](const PreparedScene& made) { return made.scene.material.specular.exponent == value; }))
            return 1;
        if (i > 0)
            latencies.push_back(millisecondsSince(moved));
    }
    const double longest = application.longest;
    const double process = (cpuMilliseconds(CLOCK_PROCESS_CPUTIME_ID) - processBefore) / steps;
    const double thread = (cpuMilliseconds(CLOCK_THREAD_CPUTIME_ID) - threadBefore) / steps;
    slider->setSliderDown(false);
    std::printf("picture                      %d x %d\n", preview.width(), preview.height());
    std::printf("start to first picture       %7.0f ms\n", first);
    std::printf("slider to picture, median    %7.1f ms\n", percentile(latencies, 0.5));
    std::printf("slider to picture, 95 %%      %7.1f ms\n", percentile(latencies, 0.95));
    std::printf("slider to picture, slowest   %7.1f ms\n", percentile(latencies, 1.0));
    std::printf("GUI thread busy at a time    %7.1f ms at most\n", longest);
    std::printf("processor time of a step     %7.1f ms, of it GUI thread %.1f ms\n", process, thread);
    document.reset();
    return 0;
}

} // namespace
} // namespace mirrorball::studio

int main(int count, char** arguments)
{
    const auto start = std::chrono::steady_clock::now();
    QStandardPaths::setTestModeEnabled(true);
    QSurfaceFormat::setDefaultFormat(mirrorball::studio::previewFormat());
    mirrorball::studio::WatchedApplication application(count, arguments);
    QCoreApplication::setOrganizationName(QStringLiteral("mirrorball-benchmark"));
    return mirrorball::studio::run(application, start);
}
