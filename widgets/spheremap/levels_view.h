#pragma once

#include "sphere_map_editor.h"

#include <QImage>
#include <QTimer>
#include <QVector>
#include <QWidget>

namespace mirrorball::studio {

/// The mip chain of the sphere map, level by level, each at the same size: small ones magnified so that their texels show, large ones
/// averaged. Made in the background while the view can be seen.
///
/// A click on a level shows and paints that one alone, on disc and model; another, or Escape, brings all of them back. Arrow keys go from
/// level to level.
class LevelsView : public QWidget {
    Q_OBJECT

public:
    explicit LevelsView(SphereMapEditor& editor, QWidget* parent = nullptr);

    /// A level and its halvings in linear light, as the screen shows them, largest first; those of more texels than fit on a screen are
    /// left out.
    struct Level {
        int size = 0; ///< texels along an edge
        QVector<QImage> pictures{};

        /// At so many pixels across: averaged where that is less than the level has.
        QImage forPixels(int pixels) const;
    };
    /// Largest first.
    const QVector<Level>& levels() const { return m_levels; }
    /// Where a level is drawn.
    QRectF cell(int level) const;
    QSize sizeHint() const override { return {260, 260}; }
    QSize minimumSizeHint() const override { return {140, 120}; }

signals:
    void updated();

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    void request();
    QString note() const;
    QRect noteArea() const;
    int levelAt(const QPointF& place) const;

    SphereMapEditor& m_editor;
    JobRunner m_runner;
    QTimer m_rest; ///< runs out when edits have come to rest
    QVector<Level> m_levels;
    QString m_problem;
    bool m_isStale = true;
    bool m_isAuthored = false;
};

} // namespace mirrorball::studio
