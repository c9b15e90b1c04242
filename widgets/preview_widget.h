#pragma once

#include "workspace.h"

#include "core/preview/renderer.h"

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QPointF>
#include <QTimer>

#include <memory>
#include <optional>

namespace mirrorball::studio {

/// The picture, live: core/preview's renderer in a window's context.
///
/// Left drag orbits, middle drag pans, the wheel zooms, F frames, R resets, Shift and right drag turns the environment, E and Shift+E
/// change the exposure. Every move is an edit of the document's view, one undo step a drag.
class PreviewWidget : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit PreviewWidget(Workspace& workspace, QWidget* parent = nullptr);
    ~PreviewWidget() override;

    QSize sizeHint() const override { return {960, 540}; }
    QSize minimumSizeHint() const override { return {160, 120}; }
    /// Why there is no picture; empty when there is one.
    const QString& problem() const { return m_problem; }

public slots:
    void frame();
    void resetView();
    void changeExposure(double ev);

signals:
    /// A picture of this scene is on its way to the screen.
    void painted(std::shared_ptr<const mirrorball::MadeScene> made);

protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    enum class Drag { None, Orbit, Pan, TurnEnvironment };
    void releaseGL();
    preview::RenderSettings settings(const MadeScene& made) const;

    Workspace& m_workspace;
    std::unique_ptr<preview::Renderer> m_renderer;
    QString m_problem;
    Drag m_drag = Drag::None;
    QPointF m_last;
    QTimer m_rest; ///< runs out when wheel and keys have come to rest
};

/// The format that windows must have: set as the default before the first one is made.
QSurfaceFormat previewFormat();

} // namespace mirrorball::studio
