#pragma once

#include "sphere_map_editor.h"

#include <QImage>
#include <QTimer>
#include <QVector>
#include <QWidget>

namespace mirrorball::studio {

/// The mip chain of the sphere map, level by level, each magnified to the same size so that its texels show. Made in the background while
/// the view can be seen.
class LevelsView : public QWidget {
    Q_OBJECT

public:
    explicit LevelsView(SphereMapEditor& editor, QWidget* parent = nullptr);

    /// The levels, largest first; those of more texels than fit on a screen are made smaller.
    struct Level {
        int size = 0; ///< texels along an edge
        QImage picture{};
    };
    const QVector<Level>& levels() const { return m_levels; }
    QSize sizeHint() const override { return {260, 260}; }
    QSize minimumSizeHint() const override { return {140, 120}; }

signals:
    void updated();

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void request();

    SphereMapEditor& m_editor;
    JobRunner m_runner;
    QTimer m_rest; ///< runs out when edits have come to rest
    QVector<Level> m_levels;
    QString m_problem;
    bool m_isStale = true;
    bool m_isAuthored = false;
};

} // namespace mirrorball::studio
