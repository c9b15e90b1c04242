#pragma once

#include <QIcon>
#include <QString>
#include <QToolButton>

namespace mirrorball::studio {

/// An icon of those compiled in, by its file's name.
inline QIcon iconOf(const char* name) { return QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name))); }

/// A flat button with an icon alone, whose name and help say what it does.
inline QToolButton* iconButton(const char* iconName, const QString& name, const QString& help)
{
    auto* result = new QToolButton;
    result->setIcon(iconOf(iconName));
    result->setAutoRaise(true);
    result->setAccessibleName(name);
    result->setToolTip(help);
    return result;
}

} // namespace mirrorball::studio
