#pragma once

#include <QApplication>
#include <QIcon>
#include <QString>

namespace mirrorball::studio {

/// Neutral grays, the same in every channel: pictures are judged on them.
void applyTheme(QApplication& application);

/// One of resources/icons.
QIcon icon(const char* name);

} // namespace mirrorball::studio
