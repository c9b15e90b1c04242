#include "text.h"

#include <QCoreApplication>

namespace mirrorball::studio {

QString fieldText(std::string_view text) { return QCoreApplication::translate("Fields", std::string(text).c_str()); }

QString labelText(std::string_view text)
{
    if (text == "ggx")
        return QStringLiteral("GGX"); // a name of letters
    QString label = fieldText(text);
    label.replace(u'_', u' ');
    if (!label.isEmpty())
        label[0] = label[0].toUpper();
    return label;
}

} // namespace mirrorball::studio
