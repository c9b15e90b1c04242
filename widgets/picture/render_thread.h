#pragma once

#include "picture_comparison.h"
#include "widgets/workspace/snapshots.h"

#include "core/preview/renderer.h"
#include "core/spheremap/evaluation/levels_cache.h"

#include <QImage>
#include <QObject>
#include <QOffscreenSurface>
#include <QString>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace mirrorball::studio {

/// All that a picture is drawn of, by value or never changing: it is drawn while the window goes on.
struct PictureOrder {
    std::shared_ptr<const PreparedScene> made{};
    preview::RenderSettings settings{};
    QSize size{}; ///< of the whole picture; side by side, two of the settings' size stand at its edges
    Comparison comparison = Comparison::Off;
    std::shared_ptr<const PreparedScene> snapshot{}; ///< where compared
    preview::RenderSettings snapshotSettings{};
    int wipe = 0;        ///< pixels from the left where the snapshot ends
    unsigned number = 0; ///< tells one order from the next

    bool operator==(const PictureOrder&) const = default;
};

struct Picture {
    QImage image{}; ///< in device pixels; null when there is a problem
    PictureOrder order{};
    double seconds = 0.0; ///< that drawing and reading back took
    QString problem{};
};

/// The two pictures of a comparison, each of the settings' size; null where they could not be drawn.
struct PicturePair {
    QImage kept{}, now{};
};

/// Radiance of the same: linear RGBA, not exposed. Empty where it could not be drawn, `kept` also where nothing is compared.
struct LightPair {
    Image kept{}, now{};
};

/// What the object shows in one pixel, and the mip level that its reflection is read at, where there is one.
struct PickedPixel {
    std::optional<preview::SurfaceHit> hit{};
    std::optional<float> level{};
};

/// Texels that a stroke changed in a map that is shown, before the map itself is made anew.
struct SphereMapPatch {
    SphereMapChain chain{};            ///< the map
    Image texels{};                    ///< of its finest level, RGBA
    TexelRect rect{};                  ///< where they belong
    std::vector<LevelPatch> coarser{}; ///< where the map's levels are made by hand; otherwise they are averages
};

/// Draws pictures with core/preview's renderer on a thread of its own, in a context of the window system that Qt made.
///
/// The picture is read back and painted as an image. A QOpenGLWidget would have the window composed in OpenGL, docks and all, with every
/// blink of a cursor; on a software renderer that takes longer than the picture, and a driver that compiles a shader holds the window.
class RenderThread : public QObject {
    Q_OBJECT

public:
    explicit RenderThread(QObject* parent = nullptr);
    /// Waits for what is being drawn.
    ~RenderThread() override;

    /// drawn() follows, unless a newer order comes before this one is begun.
    void draw(PictureOrder order);
    /// Goes into the map's texture before the next picture of it.
    void patch(SphereMapPatch patch);
    /// Where each pixel looks the painted sphere map up that is indexed so; null where nothing can be drawn. Waits for it: the time of
    /// two pictures at most.
    std::shared_ptr<const preview::DiscPlaces> discPlaces(const preview::RenderSettings& settings, SphereMapIndex index);
    /// What the pixel at (x, y) of the scene now shows, from the upper left, without waiting; of several that wait only the newest is
    /// looked up.
    void pick(const PictureOrder& order, int x, int y, std::function<void(const PickedPixel&)> use);
    /// Both pictures of a comparison whole, without waiting, when nothing else is to be drawn; of several that wait only the newest is.
    void drawPair(PictureOrder order, std::function<void(const PicturePair&)> use);
    /// Their radiance, the same way.
    void drawLight(PictureOrder order, std::function<void(const LightPair&)> use);

signals:
    void drawn(const mirrorball::studio::Picture& picture);

private:
    struct Context;
    using Look = std::function<void(Context*)>; ///< null where there is no context
    void wakeWith(Look& place, Look look);
    void run(const std::stop_token& end);

    QOffscreenSurface m_surface;
    std::mutex m_mutex; ///< guards what waits
    std::condition_variable_any m_wake;
    std::optional<PictureOrder> m_order;
    std::vector<SphereMapPatch> m_patches;
    Look m_awaitedLook;           ///< someone waits for it
    Look m_pick, m_pair, m_light; ///< each may be replaced by a newer one
    std::jthread m_thread;        ///< last: it ends first
};

} // namespace mirrorball::studio
