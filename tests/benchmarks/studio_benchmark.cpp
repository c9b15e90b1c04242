#include "app/studio/main_window.h"
#include "app/studio/theme.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/options_form.h"
#include "widgets/spheremap/sphere_map_canvas.h"

#include "core/spheremap/document/presets.h"
#include "support/stroke_builders.h"

#include <QApplication>
#include <QDockWidget>
#include <QEventLoop>
#include <QMouseEvent>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>
#include <vector>

/// From slider to picture: 200 steps of the exponent over its slider's whole range, 0.1 to 1e6, while it is dragged, in a real window
/// whose picture has 1280 x 720 pixels. A step lasts from the slider's move until the display has taken a picture with that exponent.
/// While something is dragged the studio draws one sample a pixel; the same is measured with the four of a picture at rest. Prints the
/// median and the slowest, the longest that any one event kept the GUI thread, and the time from the start of the process to the first
/// picture. Then a stroke on a sphere map, from pen to picture, and parameters of its layers, from slider to disc and to model.
///
///   xvfb-run -a -s "-screen 0 1920x1200x24" build/ci/bin/studio_benchmark [PROBE [STEPS [exponent|strokes|layers]]]
namespace mirrorball::studio {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

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

/// Waits for pictures. @return false when none came for so many milliseconds
template <typename Done>
bool waitUntil(PreviewWidget& preview, Done done, int patience = 60000)
{
    QEventLoop loop;
    QTimer::singleShot(patience, &loop, [&] { loop.exit(1); });
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

/// A stroke with the mouse on a sphere map of 1024 texels under 200 others in ten layers: from a movement, on the disc or on the model,
/// until the display has taken a picture with it. @return false when a picture did not come
bool paintStroke(MainWindow& window, WatchedApplication& application, QWidget& on, int steps)
{
    PreviewWidget& preview = window.preview();
    SphereMapEditor& editor = window.workspace().sphereMap;
    const bool isOnModel = &on == &preview;
    editor.setPaintsOnModel(isOnModel);
    const QPointF middle(0.5 * on.width(), 0.5 * on.height());
    const double reach = 0.12 * std::min(on.width(), on.height());
    const auto send = [&](QEvent::Type type, double t) {
        const QPointF at = middle + reach * QPointF(std::cos(t), 0.8 * std::sin(t));
        QMouseEvent event(type, at, on.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
        QCoreApplication::sendEvent(&on, &event);
    };
    int changes = 0;
    const auto connection = QObject::connect(&editor, &SphereMapEditor::pictureChanged, &editor, [&] { ++changes; });
    send(QEvent::MouseButtonPress, 0.0);
    std::vector<double> latencies;
    for (int i = 0; i <= steps; ++i) {
        const int before = changes;
        const auto moved = Clock::now();
        send(QEvent::MouseMove, 0.25 * (i + 1)); // far enough for new dabs
        const auto isSeen = [&](const PreparedScene&) { return changes > before && preview.isUpToDate(); };
        if (!waitUntil(preview, isSeen, isOnModel ? 2000 : 60000)) {
            if (changes == before && editor.isUpToDate())
                continue; // across an outline of the model another stroke begins, and nothing is drawn yet
            return false;
        }
        if (i == 0) // it builds what a stroke needs
            application.longest = 0.0;
        else
            latencies.push_back(millisecondsSince(moved));
    }
    if (static_cast<int>(latencies.size()) < steps / 2)
        return false;
    const double longest = application.longest;
    send(QEvent::MouseButtonRelease, 0.25 * (steps + 1));
    QObject::disconnect(connection);
    const auto released = Clock::now();
    if (!waitUntil(preview, [&](const PreparedScene&) { return window.workspace().live.isUpToDate() && preview.isUpToDate(); }))
        return false;
    std::printf("a stroke on the %s, on a sphere map of %d texels\n", isOnModel ? "model" : "disc", editor.size());
    std::printf("  pen to picture, median     %7.1f ms\n", percentile(latencies, 0.5));
    std::printf("  pen to picture, 95 %%       %7.1f ms\n", percentile(latencies, 0.95));
    std::printf("  pen to picture, slowest    %7.1f ms\n", percentile(latencies, 1.0));
    std::printf("  GUI thread busy at a time  %7.1f ms at most\n", longest);
    std::printf("  pen up to smooth edges     %7.1f ms\n", millisecondsSince(released));
    return true;
}

/// Until the display has taken them: the sphere map's disc and the model, each with what was changed last. @return milliseconds of each
/// since `moved`; nothing when one of them did not come
struct SeenAfter {
    double disc = 0.0, model = 0.0;
};
template <typename IsOfChange>
std::optional<SeenAfter> waitForBoth(MainWindow& window, IsOfChange isOfChange, Clock::time_point moved)
{
    /// Sees the canvas painted.
    struct Watch : QObject {
        std::function<void()> painted;
        bool eventFilter(QObject*, QEvent* event) override
        {
            if (event->type() == QEvent::Paint)
                QTimer::singleShot(0, this, painted); // once it is through and the window has been flushed
            return false;
        }
    };
    SeenAfter seen;
    QEventLoop loop;
    QTimer::singleShot(60000, &loop, [&] { loop.exit(1); });
    const auto isSeen = [&](double& at) {
        QGuiApplication::sync(); // the display has taken the picture
        if (at == 0.0)
            at = millisecondsSince(moved);
        if (seen.disc > 0.0 && seen.model > 0.0)
            loop.exit(0);
    };
    auto* canvas = window.findChild<SphereMapCanvas*>();
    Watch watch;
    watch.painted = [&] {
        if (window.workspace().sphereMap.isUpToDate())
            isSeen(seen.disc);
    };
    canvas->installEventFilter(&watch);
    QObject::connect(&window.preview(), &PreviewWidget::painted, &loop, [&](const std::shared_ptr<const PreparedScene>& made) {
        if (isOfChange(*made))
            QTimer::singleShot(0, &loop, [&] { isSeen(seen.model); });
    });
    return loop.exec() == 0 ? std::optional(seen) : std::nullopt;
}

/// A parameter of a layer of that map, dragged: from a movement until the display has taken the disc, and the model, with it.
/// @return false when a picture did not come
bool dragLayer(MainWindow& window, WatchedApplication& application, int steps, size_t index, const char* what,
               const std::function<void(Layer&, double)>& change)
{
    SphereMapEditor& editor = window.workspace().sphereMap;
    editor.choose(static_cast<int>(index));
    std::vector<double> disc, model;
    for (int i = 0; i <= steps; ++i) {
        const auto moved = Clock::now();
        editor.editLayer(QStringLiteral("drag"), QStringLiteral("drag"),
                         [&](Layer& layer) { change(layer, static_cast<double>(i) / steps); });
        const Layer wanted = *editor.chosenLayer();
        const auto seen = waitForBoth(
            window, [&](const PreparedScene& made) { return made.scene.material.sphereMap.document.document->layers[index] == wanted; },
            moved);
        if (!seen)
            return false;
        if (i < 2) { // they build what a drag needs
            application.longest = 0.0;
        } else {
            disc.push_back(seen->disc);
            model.push_back(seen->model);
        }
    }
    window.workspace().document.finishEdit();
    std::printf("%s of layer %zu of ten\n", what, index + 1);
    std::printf("  slider to disc, median     %7.1f ms\n", percentile(disc, 0.5));
    std::printf("  slider to disc, 95 %%       %7.1f ms\n", percentile(disc, 0.95));
    std::printf("  slider to model, median    %7.1f ms\n", percentile(model, 0.5));
    std::printf("  slider to model, 95 %%      %7.1f ms\n", percentile(model, 0.95));
    std::printf("  GUI thread busy at a time  %7.1f ms at most\n", application.longest);
    const auto isReady = [&](const PreparedScene&) { return window.workspace().live.isUpToDate() && window.preview().isUpToDate(); };
    return waitUntil(window.preview(), isReady);
}

/// The lowest layer, one in the middle and the topmost, of which the first costs what lies above it and the last has strokes.
bool dragLayers(MainWindow& window, WatchedApplication& application, int steps)
{
    const auto opacity = [](Layer& layer, double t) { layer.opacity = 0.3 + 0.6 * t; };
    const auto radius = [](Layer& layer, double t) { std::get<GradientLayer>(layer.content).radius = 0.7 + 0.4 * t; };
    return dragLayer(window, application, steps, 0, "opacity", opacity) && dragLayer(window, application, steps, 5, "opacity", opacity) &&
           dragLayer(window, application, steps, 5, "radius", radius) && dragLayer(window, application, steps, 9, "opacity", opacity);
}

/// Ten layers, three of them painted, with 200 strokes.
SphereMapDocument paintedMap()
{
    const std::vector<Stroke> strokes = handDrawnStrokes(200, 1);
    SphereMapDocument map = findSphereMapPreset("jade")->document;
    for (int i = 0; map.layers.size() < 7; ++i)
        map.layers.push_back({.opacity = 0.2, .blend = BlendMode::SoftLight, .content = GradientLayer{.shape = GradientShape::Radial}});
    for (ptrdiff_t first = 0; first < 200; first += 67)
        map.layers.push_back(
            {.name = "Paint",
             .content = PaintLayer{.strokes = {strokes.begin() + first, strokes.begin() + std::min<ptrdiff_t>(first + 67, 200)}}});
    return map;
}

/// All of it, or what the third argument names.
QString chosenPart()
{
    const QStringList arguments = QCoreApplication::arguments();
    return arguments.size() > 3 ? arguments[3] : QString();
}

/// @return false when a picture did not come
bool paint(MainWindow& window, WatchedApplication& application, int steps)
{
    window.preview().setSamplesWhileDragging(1);
    SphereMapEditor& editor = window.workspace().sphereMap;
    window.dock(QStringLiteral("sphere-map"))->raise();
    editor.setMap(QStringLiteral("map"), paintedMap());
    const auto isReady = [&](const PreparedScene& made) {
        return made.scene == window.workspace().document.scene() && window.workspace().live.isUpToDate() && window.preview().isUpToDate();
    };
    if (!waitUntil(window.preview(), isReady))
        return false;
    const QString part = chosenPart();
    return (part == QStringLiteral("layers") || (paintStroke(window, application, *window.findChild<SphereMapCanvas*>(), steps) &&
                                                 paintStroke(window, application, window.preview(), steps))) &&
           (part == QStringLiteral("strokes") || dragLayers(window, application, steps));
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
    if (!began ||
        !waitUntil(preview, [&](const PreparedScene& made) { return made.detail == MapDetail{} && made.scene == document.scene(); }))
        return 1;
    std::printf("picture                      %d x %d\n", preview.width(), preview.height());
    const int steps = arguments.size() > 2 ? std::max(1, arguments[2].toInt()) : 200;
    const QString part = chosenPart();
    const bool isDone = (part == QStringLiteral("layers") || part == QStringLiteral("strokes") ||
                         (dragExponent(window, application, steps, 1) && dragExponent(window, application, steps, 4))) &&
                        (part == QStringLiteral("exponent") || paint(window, application, steps));
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
