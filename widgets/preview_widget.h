#pragma once

#include "picture_comparison.h"
#include "workspace.h"

#include "core/preview/renderer.h"
#include "core/spheremap/texel_rect.h"

#include <QOpenGLWidget>
#include <QPointF>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace mirrorball::studio {

/// The picture, live: core/preview's renderer in a window's context.
///
/// Left drag orbits, middle drag pans, the wheel zooms, Shift and right drag turns the environment. Every move is an edit of the
/// document's view, one undo step a drag. A snapshot keeps a scene with its maps, to be compared from where the camera is now; while B is
/// held it is shown.
class PreviewWidget : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit PreviewWidget(Workspace& workspace, QWidget* parent = nullptr);
    ~PreviewWidget() override;

    QSize sizeHint() const override { return {960, 540}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

    /// What the picture shows at a place of the widget; nothing beside the model.
    std::optional<preview::SurfaceHit> pick(const QPointF& position);

    bool hasSnapshot() const { return m_snapshot != nullptr; }
    Comparison comparison() const { return m_comparison; }
    /// Where the wipe's line stands, as a fraction of the width.
    double wipe() const { return m_wipe; }

public slots:
    /// Brings the object back to the middle, at the size it has at first.
    void frame();
    void resetView();
    void changeExposure(double ev);
    /// Keeps what is shown now, for comparison.
    void takeSnapshot();
    /// Off without a snapshot.
    void setComparison(mirrorball::studio::Comparison comparison);
    void setWipe(double fraction);

signals:
    /// A picture of this scene is on its way to the screen. @param seconds that drawing it took
    void painted(std::shared_ptr<const mirrorball::studio::PreparedScene> made, double seconds);
    void comparisonChanged();

protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    enum class Drag { None, Orbit, Pan, TurnEnvironment, Wipe };

    void releaseGL();
    QSize deviceSize() const;
    preview::RenderSettings settings(const PreparedScene& made) const;
    void draw(preview::Renderer& renderer, const PreparedScene& made, const preview::Destination& destination);
    void patchSphereMap(const PreparedScene& made);
    void patchLevels(const SphereMapTexels& chain, const TexelRect& fresh);
    void paintComparison(const PreparedScene& made);
    void drag(const QPointF& moved);
    void point();
    bool isOnWipe(const QPointF& position) const;

    Workspace& m_workspace;
    std::unique_ptr<preview::Renderer> m_renderer;
    std::unique_ptr<preview::Renderer> m_snapshotRenderer; ///< of its own, so that neither drops the other's textures
    PictureDifference m_difference;
    SphereMapChain m_shownSphereMap; ///< that the last picture read
    TexelRect m_strokeRect;          ///< where a stroke that is being drawn has changed the sphere map since it was made
    TexelRect m_freshRect;           ///< the part of it that the texture does not hold yet
    std::vector<TexelRect> m_strokeLevels; ///< the same of the coarser levels, where they are made by hand
    std::vector<TexelRect> m_freshLevels;
    std::shared_ptr<const PreparedScene> m_snapshot;
    Comparison m_comparison = Comparison::Off;
    std::optional<Comparison> m_beforeHold{}; ///< while the key is held that shows the snapshot
    double m_wipe = 0.5;
    Drag m_drag = Drag::None;
    QPointF m_last;
    QTimer m_rest;     ///< runs out when wheel and keys have come to rest
    QTimer m_pointing; ///< a moving mouse looks at the model this often
    bool m_isPointing = false;
};

/// The format that windows must have: set as the default before the first one is made.
QSurfaceFormat previewFormat();

} // namespace mirrorball::studio
