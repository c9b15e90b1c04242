#pragma once

#include "widgets/picture/preview_widget.h"

#include <QActionGroup>
#include <QMenu>
#include <QObject>
#include <QToolBar>

#include <functional>

namespace mirrorball::studio {

/// The commands that act on the picture: geometry, shading, projection, background, camera, exposure, comparison. Each is an action of
/// the View menu; the tool bar above the picture shows most of them.
class ViewActions : public QObject {
    Q_OBJECT

public:
    ViewActions(PreviewWidget& preview, Workspace& workspace, QObject* parent = nullptr);

    void addTo(QMenu& menu);
    void addTo(QToolBar& bar);
    /// What can be done with the picture, where the mouse is. @param others  commands of elsewhere that belong there, too
    void popUp(const QPoint& global, const QList<QAction*>& others);
    /// Keys without Ctrl or Alt work while this widget or one inside it has the keys: typed elsewhere they change nothing.
    void addKeysTo(QWidget& widget);

signals:
    /// A command has changed the scene, in words for the status line.
    void said(const QString& text);

private:
    QAction* add(const char* id, const char* iconName, const QString& text, const QString& help, const QKeySequence& key,
                 std::function<void()> act);
    /// An action that is checked while `isOn` holds of the scene.
    QAction* addChoice(QActionGroup& group, const char* id, const char* iconName, const QString& text, const QKeySequence& key,
                       const QString& undoLabel, std::function<void(Scene&)> choose, std::function<bool(const Scene&)> isOn);
    void addHabit(QActionGroup& group, const QString& id, const char* iconName, const QString& text, const QString& help,
                  std::function<void()> use);
    void makeGeometry();
    void makeShading();
    void makeCamera();
    void makeBackground();
    void makeComparison();
    void makeHabits();
    void makeInspection();
    void refresh();
    void say();

    PreviewWidget& m_preview;
    Workspace& m_workspace;
    QActionGroup m_geometry, m_shading, m_projection, m_background, m_compare, m_turn, m_mouse;
    QList<QAction*> m_camera, m_exposure, m_inspect, m_plainKeys;
    QAction* m_lookup = nullptr;
    QAction* m_snapshot = nullptr;
    QVector<std::pair<QAction*, std::function<bool(const Scene&)>>> m_choices;
};

} // namespace mirrorball::studio
