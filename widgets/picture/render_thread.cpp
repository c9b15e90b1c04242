#include "render_thread.h"

#include "cut_out.h"

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/preview/scene_settings.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QSurfaceFormat>

#include <algorithm>
#include <future>
#include <utility>

namespace mirrorball::studio {

namespace {

constexpr float differenceGain = 4.0f;

QSurfaceFormat contextFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(0); // the renderer has targets of its own
    format.setStencilBufferSize(0);
    return format;
}

/// Every 2 x 2 texels become one.
Image averaged(const Image& finer)
{
    Image coarse(finer.width / 2, finer.height / 2, 4);
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x)
            for (int c = 0; c < 4; ++c)
                coarse.texel(x, y)[c] = 0.25f * (finer.texel(2 * x, 2 * y)[c] + finer.texel(2 * x + 1, 2 * y)[c] +
                                                 finer.texel(2 * x, 2 * y + 1)[c] + finer.texel(2 * x + 1, 2 * y + 1)[c]);
    return coarse;
}

/// The whole texels of the next level inside a rectangle of this one. A row or column that only half covers one of them waits for the
/// end of the stroke.
TexelRect halved(const TexelRect& rect) { return {(rect.x0 + 1) / 2, (rect.y0 + 1) / 2, rect.x1 / 2, rect.y1 / 2}; }

/// Reads a part of the target into the picture of all of it. Rows of OpenGL run from the bottom.
void readPart(const preview::RenderTarget& target, const preview::PixelRectangle& part, QImage& image, std::vector<quint32>& rgba)
{
    if (part.width <= 0 || part.height <= 0)
        return;
    rgba.resize(static_cast<size_t>(part.width) * static_cast<size_t>(part.height));
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glReadPixels(part.x, part.y, part.width, part.height, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, rgba.data());
    const quint32 opacity = image.hasAlphaChannel() ? 0u : 0xff000000u;
    for (int row = 0; row < part.height; ++row) {
        const quint32* from = rgba.data() + static_cast<size_t>(row) * static_cast<size_t>(part.width);
        std::transform(from, from + part.width, reinterpret_cast<quint32*>(image.scanLine(target.height - 1 - part.y - row)) + part.x,
                       [opacity](quint32 abgr) { return (abgr & 0xff00ff00u) | (abgr & 0xffu) << 16 | (abgr >> 16 & 0xffu) | opacity; });
    }
}

QImage readPicture(const preview::RenderTarget& target, bool isOpaque, std::vector<quint32>& rgba)
{
    QImage image(target.width, target.height, isOpaque ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied);
    readPart(target, {0, 0, target.width, target.height}, image, rgba);
    return image;
}

/// Whether two pictures are the same beside the rectangle that their object can touch: while a material or its maps are dragged, they are.
bool differInObjectOnly(const PictureOrder& a, const PictureOrder& b)
{
    preview::RenderSettings settings = a.settings; // with what only the object shows of the other
    settings.material = b.settings.material;
    settings.marker = b.settings.marker;
    settings.samples = b.settings.samples;
    settings.smoothEdges = b.settings.smoothEdges;
    settings.objectCurve = b.settings.objectCurve;
    return a.comparison == Comparison::Off && b.comparison == Comparison::Off && a.size == b.size && settings == b.settings &&
           a.made->maps.background == b.made->maps.background;
}

} // namespace

/// What belongs to the thread: its context, and all that lives in it.
struct RenderThread::Context {
    QOpenGLContext context{};
    preview::RenderTarget target{};
    preview::Renderer renderer{};
    std::unique_ptr<preview::Renderer> snapshotRenderer{}; ///< of its own, so that neither drops the other's textures
    PictureDifference difference{};
    SphereMapChain shownMap{}; ///< that the last picture read
    std::vector<quint32> pixels{};
    std::optional<Picture> last{}; ///< that the target holds

    explicit Context(QOffscreenSurface& surface)
    {
        context.setFormat(contextFormat());
        if (!context.create() || !context.makeCurrent(&surface))
            throw WorkError(
                "the preview needs OpenGL 4.5 and the window system offers no context for it; install a newer driver, or Mesa's "
                "software renderer: apt install libgl1-mesa-dri");
    }

    Picture draw(const PictureOrder& order, const std::vector<SphereMapPatch>& patches)
    {
        Picture picture{.order = order};
        QElapsedTimer clock;
        clock.start();
        const int width = order.size.width(), height = order.size.height();
        if (!target.fits(width, height, 1, GL_RGBA8)) {
            target = preview::RenderTarget(); // the old one goes before the new one comes
            target = preview::RenderTarget(width, height, 1, GL_RGBA8, 1, GL_NONE);
        }
        const std::optional<Picture> before = std::exchange(last, std::nullopt); // nothing is held of a picture that fails
        patchMap(order, patches);
        if (before && differInObjectOnly(before->order, order)) {
            // On a software renderer the background takes as long as the object, and no less to read back.
            const preview::PixelRectangle part = renderer.objectPart(order.settings);
            drawNow(order, {.framebuffer = target.framebuffer, .clip = part});
            picture.image = before->image;
            readPart(target, part, picture.image, pixels);
        } else {
            paint(order);
            picture.image = readPicture(target, order.settings.background.kind != Backdrop::None, pixels);
        }
        picture.seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
        last = picture;
        return picture;
    }

    PicturePair drawPair(const PictureOrder& order)
    {
        drawBoth(order);
        const bool isOpaque = order.settings.background.kind != Backdrop::None;
        return {readPicture(difference.drawn(1), isOpaque, pixels), readPicture(difference.drawn(0), isOpaque, pixels)};
    }

    LightPair drawLight(const PictureOrder& order)
    {
        LightPair light{.now = renderer.renderRadiance(order.settings, preview::renderMaps(order.made->maps))};
        if (order.snapshot)
            light.kept = keptRenderer().renderRadiance(order.snapshotSettings, preview::renderMaps(order.snapshot->maps));
        return light;
    }

    PickedPixel pick(const PictureOrder& order, int x, int y)
    {
        PickedPixel pixel{.hit = renderer.pick(order.settings, x, y)};
        if (pixel.hit)
            pixel.level = renderer.level(order.settings, preview::renderMaps(order.made->maps), x, y);
        return pixel;
    }

private:
    preview::Renderer& keptRenderer()
    {
        if (!snapshotRenderer)
            snapshotRenderer = std::make_unique<preview::Renderer>();
        return *snapshotRenderer;
    }

    void drawNow(const PictureOrder& order, const preview::Destination& destination)
    {
        renderer.drawDisplay(order.settings, preview::renderMaps(order.made->maps), destination);
    }

    void drawKept(const PictureOrder& order, const preview::Destination& destination)
    {
        keptRenderer().drawDisplay(order.snapshotSettings, preview::renderMaps(order.snapshot->maps), destination);
    }

    void drawBoth(const PictureOrder& order)
    {
        const int width = order.settings.width, height = order.settings.height;
        drawNow(order, {.framebuffer = difference.target(0, width, height)});
        drawKept(order, {.framebuffer = difference.target(1, width, height)});
    }

    void paint(const PictureOrder& order)
    {
        const int width = order.settings.width, height = order.settings.height;
        switch (order.comparison) {
        case Comparison::Off:
            snapshotRenderer.reset();
            drawNow(order, {.framebuffer = target.framebuffer});
            break;
        case Comparison::Hold:
            drawKept(order, {.framebuffer = target.framebuffer});
            break;
        case Comparison::Wipe:
            drawKept(order, {.framebuffer = target.framebuffer, .clip = preview::PixelRectangle{0, 0, order.wipe, height}});
            drawNow(order, {.framebuffer = target.framebuffer, .clip = preview::PixelRectangle{order.wipe, 0, width - order.wipe, height}});
            break;
        case Comparison::SideBySide:
            clearGap();
            drawKept(order, {.framebuffer = target.framebuffer});
            drawNow(order, {.framebuffer = target.framebuffer, .x = order.size.width() - width});
            break;
        case Comparison::Difference:
            drawBoth(order);
            difference.draw(target.framebuffer, differenceGain);
            break;
        }
    }

    // Where a width is odd, a column between the two is neither's.
    void clearGap()
    {
        const float dark[] = {0.1f, 0.1f, 0.1f, 1.0f};
        glDisable(GL_SCISSOR_TEST);
        glClearNamedFramebufferfv(target.framebuffer, GL_COLOR, 0, dark);
    }

    // A stroke that is being drawn goes straight into the texture, only where it touched; when it is done, the scene's maps hold it.
    void patchMap(const PictureOrder& order, const std::vector<SphereMapPatch>& patches)
    {
        const SphereMapChain chain = order.made->maps.sphereMaps.empty() ? nullptr : order.made->maps.sphereMaps.front();
        const auto isOfShown = [&](const SphereMapPatch& patch) { return patch.chain == chain; };
        if (std::any_of(patches.begin(), patches.end(), isOfShown) && chain != shownMap) // a new texture is made by drawing
            renderer.drawDisplay(order.settings, preview::renderMaps(order.made->maps),
                                 {.framebuffer = target.framebuffer, .clip = preview::PixelRectangle{0, 0, 1, 1}});
        shownMap = chain;
        for (const SphereMapPatch& patch : patches)
            if (isOfShown(patch))
                apply(patch);
    }

    void apply(const SphereMapPatch& patch)
    {
        renderer.patchSphereMap(patch.texels, patch.rect.x0, patch.rect.y0, 0);
        if (patch.chain->hasAuthoredLevels || !patch.coarser.empty()) { // the stroke may be the first that has a level
            for (const LevelPatch& level : patch.coarser)
                renderer.patchSphereMap(level.texels, level.rect.x0, level.rect.y0, level.level);
            return;
        }
        Image part = patch.texels;
        TexelRect rect = patch.rect;
        for (int level = 1; level < static_cast<int>(patch.chain->levels.size()); ++level) {
            const TexelRect next = halved(rect);
            if (next.empty() || next.x1 > patch.chain->levels[static_cast<size_t>(level)].width)
                return;
            const TexelRect even{2 * next.x0 - rect.x0, 2 * next.y0 - rect.y0, 2 * next.x1 - rect.x0, 2 * next.y1 - rect.y0};
            part = averaged(cutOut(part, even));
            rect = next;
            renderer.patchSphereMap(part, rect.x0, rect.y0, level);
        }
    }
};

RenderThread::RenderThread(QObject* parent) : QObject(parent)
{
    m_surface.setFormat(contextFormat());
    m_surface.create(); // on the window's thread, as some window systems want it
    m_thread = std::jthread([this](const std::stop_token& end) { run(end); });
}

RenderThread::~RenderThread()
{
    m_thread.request_stop();
    m_thread.join();
}

void RenderThread::draw(PictureOrder order)
{
    {
        const std::lock_guard lock(m_mutex);
        m_order = std::move(order);
    }
    m_wake.notify_one();
}

void RenderThread::patch(SphereMapPatch patch)
{
    const std::lock_guard lock(m_mutex);
    m_patches.push_back(std::move(patch));
}

/// Does something with what the thread has, when nothing more urgent waits.
void RenderThread::wakeWith(Look& place, Look look)
{
    {
        const std::lock_guard lock(m_mutex);
        place = std::move(look);
    }
    m_wake.notify_one();
}

std::shared_ptr<const preview::DiscPlaces> RenderThread::discPlaces(const preview::RenderSettings& settings, SphereMapIndex index)
{
    std::promise<std::shared_ptr<const preview::DiscPlaces>> promised;
    wakeWith(m_awaitedLook, [&](Context* context) {
        std::shared_ptr<const preview::DiscPlaces> places;
        failureOf([&] { // the next picture says what is wrong, here and below
            if (context)
                places = std::make_shared<const preview::DiscPlaces>(context->renderer.discPlaces(settings, index));
        });
        promised.set_value(places);
    });
    return promised.get_future().get();
}

/// A look whose result is used on the thread of `owner`.
template <typename Context, typename Find, typename Use>
static auto lookFor(QObject* owner, Find find, Use use)
{
    return [owner, find = std::move(find), use = std::move(use)](Context* context) {
        decltype(find(*context)) found{};
        failureOf([&] {
            if (context)
                found = find(*context);
        });
        QMetaObject::invokeMethod(
            owner, [use, found = std::move(found)] { use(found); }, Qt::QueuedConnection);
    };
}

void RenderThread::pick(const PictureOrder& order, int x, int y, std::function<void(const PickedPixel&)> use)
{
    wakeWith(m_pick, lookFor<Context>(
                         this, [order, x, y](Context& context) { return context.pick(order, x, y); }, std::move(use)));
}

void RenderThread::drawPair(PictureOrder order, std::function<void(const PicturePair&)> use)
{
    wakeWith(m_pair, lookFor<Context>(
                         this, [order = std::move(order)](Context& context) { return context.drawPair(order); }, std::move(use)));
}

void RenderThread::drawLight(PictureOrder order, std::function<void(const LightPair&)> use)
{
    wakeWith(m_light, lookFor<Context>(
                          this, [order = std::move(order)](Context& context) { return context.drawLight(order); }, std::move(use)));
}

void RenderThread::run(const std::stop_token& end)
{
    std::unique_ptr<Context> context;
    const QString problem = QString::fromStdString(failureOf([&] { context = std::make_unique<Context>(m_surface); }));
    for (;;) {
        std::optional<PictureOrder> order;
        std::vector<SphereMapPatch> patches;
        Look waiting;
        {
            std::unique_lock lock(m_mutex);
            if (!m_wake.wait(lock, end, [this] { return m_order || m_awaitedLook || m_pick || m_pair || m_light; }))
                return;
            if (m_order && !m_awaitedLook) {
                order = std::exchange(m_order, std::nullopt);
                patches = std::exchange(m_patches, {});
            } else {
                for (Look* look : {&m_awaitedLook, &m_pick, &m_pair, &m_light}) // the most urgent first
                    if (!waiting)
                        waiting = std::exchange(*look, nullptr);
            }
        }
        if (waiting) {
            waiting(context.get());
            continue;
        }
        Picture picture{.order = *order, .problem = problem};
        if (context)
            picture.problem = QString::fromStdString(failureOf([&] { picture = context->draw(*order, patches); }));
        QMetaObject::invokeMethod(
            this, [this, picture] { emit drawn(picture); }, Qt::QueuedConnection);
    }
}

} // namespace mirrorball::studio
