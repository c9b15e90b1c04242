#pragma once

#include "comparison_labels.h"
#include "comparison_meter.h"
#include "mouse_preset.h"
#include "picture_inspector.h"
#include "render_thread.h"
#include "widgets/workspace/workspace.h"

#include <QPointF>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace mirrorball::studio {

/// What turns the environment. Tools of the trade differ, and hands are used to theirs.
enum class TurnGesture { ShiftRight, ControlLeft, ControlMiddle };

/// The picture, live, as the render thread draws it.
///
/// Left drag orbits, middle drag pans - or as another MousePreset says -, the wheel zooms, Shift and right drag - or another
/// TurnGesture - turns the environment. Every move is an edit of the
/// document's view, one undo step a drag. The snapshot that is A is compared from where the camera is now; while B
/// is held it is shown.
class PreviewWidget : public QWidget {
    Q_OBJECT

public:
    explicit PreviewWidget(Workspace& workspace, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {960, 540}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

    /// The newest picture, in device pixels; null before the first.
    const QImage& picture() const { return m_picture.image; }
    /// Whether picture() is of all that is known: nothing waits to be drawn.
    bool isUpToDate() const { return !m_isDue && !m_isDrawing && !m_picture.image.isNull(); }
    /// The place on a sphere map indexed so that colors a place of the widget; nothing beside the model. After the camera has moved it
    /// waits until all places have been looked up; until it moves again they are known.
    std::optional<glm::dvec2> discPlaceAt(const QPointF& position, SphereMapIndex index);

    /// Samples a pixel while something is dragged or painted; smooth edges follow when that ends. 1 at first: then a painted map is read
    /// without anisotropy, too.
    void setSamplesWhileDragging(int samples) { m_dragSamples = samples; }
    PictureInspector& inspector() { return *m_inspector; }
    TurnGesture turnGesture() const { return m_turnGesture; }
    void setTurnGesture(TurnGesture gesture) { m_turnGesture = gesture; }
    const MousePreset& mousePreset() const { return m_mouse; }
    void setMousePreset(const MousePreset& preset) { m_mouse = preset; }
    bool hasSnapshot() const { return m_workspace.snapshots.compared() != nullptr; }
    Comparison comparison() const { return m_workspace.snapshots.comparison(); }
    /// Where the wipe's line stands, as a fraction of the width.
    double wipe() const { return m_wipe; }

public slots:
    /// Brings the object back to the middle, at the size it has at first.
    void frame();
    void resetView();
    void changeExposure(double ev);
    /// Back to 0 EV.
    void resetExposure();
    /// Keeps what is shown now, for comparison.
    void takeSnapshot();
    /// Off without a snapshot.
    void setComparison(mirrorball::studio::Comparison comparison);
    void setWipe(double fraction);

signals:
    /// A new picture of this scene is on its way to the screen. @param seconds that drawing it took
    void painted(std::shared_ptr<const mirrorball::studio::PreparedScene> made, double seconds);
    void comparisonChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    enum class Drag { None, Orbit, Pan, Zoom, TurnEnvironment, Wipe };

    QSize deviceSize() const;
    QSize sceneSize() const;
    std::optional<QPointF> nowPixel(const QPointF& position) const;
    preview::RenderSettings settings(const PreparedScene& made) const;
    void redraw();
    void order();
    bool patchSphereMap(const PreparedScene& made);
    void show(const Picture& picture);
    Drag dragOf(const QMouseEvent& event) const;
    bool isTurn(const QMouseEvent& event) const;
    void zoom(double factor);
    void drag(const QPointF& moved);
    void point();
    bool isOnWipe(const QPointF& position) const;

    Workspace& m_workspace;
    RenderThread m_thread;
    ComparisonMeter m_meter;
    ComparisonLabels* m_labels;
    PictureInspector* m_inspector;
    Picture m_picture;
    PictureOrder m_ordered;                ///< the newest
    bool m_isDue = false;                  ///< something changed: an order follows when all of this moment's events are through
    bool m_isDrawing = false;              ///< the newest order is not fulfilled
    bool m_isNew = false;                  ///< the picture has not been painted yet
    SphereMapChain m_patchedMap;           ///< that the newest order reads
    TexelRect m_strokeRect;                ///< where a stroke that is being drawn has changed the sphere map since it was made
    TexelRect m_freshRect;                 ///< the part of it that the texture does not hold yet
    std::vector<TexelRect> m_strokeLevels; ///< the same of the coarser levels, where they are made by hand
    std::vector<TexelRect> m_freshLevels;
    std::optional<Comparison> m_beforeHold{}; ///< while the key is held that shows the snapshot
    double m_wipe = 0.5;
    int m_dragSamples = 1;
    TurnGesture m_turnGesture = TurnGesture::ShiftRight;
    MousePreset m_mouse = mousePresets.front();
    Drag m_drag = Drag::None;
    QPointF m_last;
    QTimer m_rest;     ///< runs out when wheel and keys have come to rest
    QTimer m_pointing; ///< a moving mouse looks at the model this often
    bool m_isPointing = false;
    std::shared_ptr<const preview::DiscPlaces> m_places;
    std::optional<std::pair<preview::RenderSettings, SphereMapIndex>> m_placesOf; ///< what they were looked up for
};

} // namespace mirrorball::studio
