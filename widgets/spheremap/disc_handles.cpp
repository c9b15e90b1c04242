#include "disc_handles.h"

#include "handle_glyphs.h"
#include "widgets/controls/text.h"

#include <QKeyEvent>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr double reach = 11.0; ///< pixels: how near to a handle a press takes it
const QString mergeKey = QStringLiteral("handle");

/// A handle's place as it is drawn: what lies on the ball's back stands at the rim.
glm::dvec2 shownPlace(const DiscHandle& handle)
{
    const double length = glm::length(handle.place);
    const bool onBall = handle.kind == HandleKind::Light || handle.kind == HandleKind::Place;
    return onBall && length > 1.0 ? handle.place / length : handle.place;
}

} // namespace

DiscHandles::DiscHandles(SphereMapEditor& editor, View view, QObject* parent) : QObject(parent), m_editor(editor), m_view(std::move(view))
{
    connect(&m_editor, &SphereMapEditor::mapChanged, this, &DiscHandles::follow);
    connect(&m_editor, &SphereMapEditor::toolChanged, this, &DiscHandles::follow);
    connect(&m_editor, &SphereMapEditor::chosenChanged, this, [this] {
        m_chosen = 0;
        m_hovered = -1;
        follow();
    });
    connect(&m_editor, &SphereMapEditor::lightChanged, this, &DiscHandles::followLight);
    follow();
}

void DiscHandles::follow()
{
    const Layer* layer = m_editor.chosenLayer();
    // A level that is shown alone is there to be painted.
    const bool isFree =
        layer && layer->visible && !m_editor.paintTarget() && m_editor.tool() != PaintTool::PickColor && !m_editor.onlyLevel();
    m_handles = isFree ? discHandles(layer->content) : std::vector<DiscHandle>();
    m_ofLayer = static_cast<int>(m_handles.size());
    if (isFree && layer->mask)
        for (DiscHandle& handle : discHandles(layer->mask->content)) {
            handle.light.reset(); // lists are edited on the layer itself
            m_handles.push_back(std::move(handle));
        }
    m_isActive = !m_handles.empty() || (isFree && holdsLights(layer->content));
    const int count = static_cast<int>(m_handles.size());
    m_chosen = count == 0 ? -1 : std::clamp(m_chosen, 0, count - 1);
    m_hovered = m_hovered < count ? m_hovered : -1;
    if (m_chosen < 0)
        m_drag.reset();
    else if (const auto& light = m_handles[static_cast<size_t>(m_chosen)].light)
        m_editor.chooseLight(*light);
    emit changed();
}

void DiscHandles::followLight()
{
    for (size_t i = 0; i < m_handles.size(); ++i)
        if (m_handles[i].light == m_editor.chosenLight())
            choose(static_cast<int>(i));
}

void DiscHandles::choose(int handle)
{
    if (handle == m_chosen || handle < 0 || handle >= static_cast<int>(m_handles.size()))
        return;
    m_chosen = handle;
    if (const auto& light = m_handles[static_cast<size_t>(handle)].light)
        m_editor.chooseLight(*light);
    emit changed();
}

QPointF DiscHandles::shownAt(int handle) const { return m_view.placeOf(shownPlace(m_handles[static_cast<size_t>(handle)])); }

int DiscHandles::at(const QPointF& place) const
{
    int found = -1;
    double nearest = reach;
    for (int i = 0; i < static_cast<int>(m_handles.size()); ++i) {
        const QPointF off = shownAt(i) - place;
        double distance = std::hypot(off.x(), off.y());
        if (i == m_chosen && distance < reach)
            distance *= 0.5; // of two that lie together the chosen one
        if (distance < nearest) {
            nearest = distance;
            found = i;
        }
    }
    return found;
}

QString DiscHandles::describe(int handle) const
{
    const DiscHandle& shown = m_handles[static_cast<size_t>(handle)];
    QStringList values;
    for (const HandleValue& value : shown.values) {
        const bool isAngle = value.unit == "degrees";
        const QString number = QLocale().toString(value.value, 'f', isAngle ? 1 : 3);
        values << tr("%1 %2").arg(fieldText(value.field).replace(u'-', u' '), isAngle ? number + u'°' : number);
    }
    const QString text = values.join(tr(", "));
    if (isOfMask(handle))
        return tr("Mask: %1").arg(text);
    if (shown.light)
        return tr("Light %1: %2").arg(*shown.light + 1).arg(text);
    return text.left(1).toUpper() + text.mid(1);
}

QString DiscHandles::hint() const
{
    const Layer* layer = m_editor.chosenLayer();
    if (layer && holdsLights(layer->content))
        return tr("Drag a light, or double-click to add one; to paint, choose a paint layer");
    return tr("Drag a handle to change the layer; to paint, choose a paint layer");
}

/// What the chosen handle belongs to. Every change of a drag has one key, so that they are one undo step.
void DiscHandles::edit(const QString& label, const std::function<void(LayerContent&)>& change)
{
    m_editor.editLayer(label, mergeKey, [&](Layer& layer) {
        if (m_chosen >= 0 && isOfMask(m_chosen)) {
            if (layer.mask)
                change(layer.mask->content);
        } else {
            change(layer.content);
        }
    });
}

void DiscHandles::moveChosen(const glm::dvec2& wanted)
{
    const auto handle = static_cast<size_t>(isOfMask(m_chosen) ? m_chosen - m_ofLayer : m_chosen);
    edit(tr("Move a handle"), [&](LayerContent& content) { moveHandle(content, handle, wanted); });
}

void DiscHandles::dragFrom(const QPointF& place)
{
    const Layer& layer = *m_editor.chosenLayer();
    m_drag = Drag{.grabbed = m_handles[static_cast<size_t>(m_chosen)].place - m_view.discAt(place),
                  .before = isOfMask(m_chosen) ? layer.mask->content : layer.content};
}

bool DiscHandles::press(const QPointF& place)
{
    const int handle = at(place);
    if (handle < 0)
        return false;
    m_editor.finishEdit();
    choose(handle);
    dragFrom(place);
    emit changed();
    return true;
}

bool DiscHandles::addAt(const QPointF& place)
{
    const Layer* layer = m_editor.chosenLayer();
    const glm::dvec2 q = m_view.discAt(place);
    if (!m_isActive || !layer || !holdsLights(layer->content) || glm::length(q) > 1.0)
        return false;
    const LayerContent before = layer->content;
    const std::optional<int> like = m_chosen >= 0 ? m_handles[static_cast<size_t>(m_chosen)].light : std::nullopt;
    m_editor.finishEdit();
    std::optional<int> added;
    m_editor.editLayer(tr("Add a light"), mergeKey, [&](Layer& changed) { added = addLight(changed.content, q, like); });
    if (!added)
        return false;
    choose(*added); // a list of lights has a handle for each, in its order
    dragFrom(place);
    m_drag->before = before;
    return true;
}

void DiscHandles::move(const QPointF& place)
{
    if (!m_drag)
        return;
    moveChosen(m_drag->grabbed + m_view.discAt(place));
}

void DiscHandles::release()
{
    if (!m_drag)
        return;
    m_drag.reset();
    m_editor.finishEdit();
    emit changed();
}

void DiscHandles::cancel()
{
    if (!m_drag)
        return;
    edit(tr("Move a handle"), [before = m_drag->before](LayerContent& content) { content = before; });
    release();
}

void DiscHandles::hover(const std::optional<QPointF>& place)
{
    const int handle = place ? at(*place) : -1;
    if (handle == m_hovered)
        return;
    m_hovered = handle;
    emit changed();
}

void DiscHandles::nudge(const glm::dvec2& by) { moveChosen(m_handles[static_cast<size_t>(m_chosen)].place + by); }

void DiscHandles::removeChosen()
{
    const std::optional<int> light = m_handles[static_cast<size_t>(m_chosen)].light;
    m_editor.finishEdit();
    m_editor.editLayer(tr("Remove a light"), {}, [&](Layer& layer) { removeLight(layer.content, *light); });
}

bool DiscHandles::pressKey(const QKeyEvent& event)
{
    if (m_chosen < 0 || m_drag)
        return false;
    const bool along = event.modifiers().testFlag(Qt::ControlModifier);
    const double step = event.modifiers().testFlag(Qt::ShiftModifier) ? 0.001 : 0.01;
    const auto arrow = [&](double x, double y) {
        const int count = static_cast<int>(m_handles.size());
        if (along)
            choose((m_chosen + (x + y > 0.0 ? 1 : count - 1)) % count);
        else
            nudge(step * glm::dvec2(x, y));
        return true;
    };
    switch (event.key()) {
    case Qt::Key_Left:
        return arrow(-1.0, 0.0);
    case Qt::Key_Right:
        return arrow(1.0, 0.0);
    case Qt::Key_Up:
        return arrow(0.0, 1.0);
    case Qt::Key_Down:
        return arrow(0.0, -1.0);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (!m_handles[static_cast<size_t>(m_chosen)].light)
            return false;
        removeChosen();
        return true;
    default:
        return false;
    }
}

/// A key that is held moves on and on: one step of undo.
void DiscHandles::releaseKey()
{
    if (m_isActive && !m_drag)
        m_editor.finishEdit();
}

void DiscHandles::paint(QPainter& painter, const QRectF& area, Focus focus) const
{
    const auto paintOne = [&](int i) {
        const DiscHandle& handle = m_handles[static_cast<size_t>(i)];
        paintHandle(painter, {.kind = handle.kind,
                              .place = shownAt(i),
                              .from = m_view.placeOf(handle.from),
                              .color = handle.color,
                              .isChosen = i == m_chosen,
                              .isHovered = i == m_hovered,
                              .hasFocus = focus == Focus::Keys,
                              .isOfMask = isOfMask(i),
                              .isBehind = handle.kind == HandleKind::Light && glm::length(handle.place) > 1.0});
    };
    for (int i = 0; i < static_cast<int>(m_handles.size()); ++i)
        if (i != m_chosen)
            paintOne(i);
    if (m_chosen < 0)
        return;
    paintOne(m_chosen);
    if (m_drag)
        paintHandleNote(painter, shownAt(m_chosen), describe(m_chosen), area);
}

} // namespace mirrorball::studio
