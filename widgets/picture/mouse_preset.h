#pragma once

#include <QtCore/qnamespace.h>

#include <array>
#include <optional>

/// What a drag in the picture does. Tools of the trade differ, and hands are used to theirs.
namespace mirrorball::studio {

/// A button with its modifiers, none but these.
struct MouseGesture {
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers{};
    bool operator==(const MouseGesture&) const = default;
};

/// A preset: one row. The wheel zooms in each.
struct MousePreset {
    const char* id;    ///< of the settings; never changes
    const char* title; ///< source text, translated in the context "MousePresets"
    MouseGesture orbit, pan;
    MouseGesture zoom; ///< NoButton: only the wheel
};

inline constexpr std::array mousePresets{
    MousePreset{
        "mirrorball", QT_TRANSLATE_NOOP("MousePresets", "Left orbits, middle pans"), {Qt::LeftButton, {}}, {Qt::MiddleButton, {}}, {}},
    MousePreset{"alt",
                QT_TRANSLATE_NOOP("MousePresets", "Alt and left orbit, middle pan, right zoom (Maya, Substance)"),
                {Qt::LeftButton, Qt::AltModifier},
                {Qt::MiddleButton, Qt::AltModifier},
                {Qt::RightButton, Qt::AltModifier}},
    MousePreset{"middle",
                QT_TRANSLATE_NOOP("MousePresets", "Middle orbits, with Shift pans, with Ctrl zooms (Blender)"),
                {Qt::MiddleButton, {}},
                {Qt::MiddleButton, Qt::ShiftModifier},
                {Qt::MiddleButton, Qt::ControlModifier}},
};

} // namespace mirrorball::studio
