#pragma once

#include <QString>
#include <QVector>

class QWidget;

/// The guide (docs/*.md) as it is compiled into the studio.
namespace mirrorball::studio {

struct GuidePage {
    QString file;  ///< "sphere-maps.md"
    QString title; ///< of its first heading
};
/// All pages, in the order of the guide's own table; the table itself first.
const QVector<GuidePage>& guidePages();
/// The text of a page, Markdown; empty where there is none.
QString guideText(const QString& file);
/// A heading as links name it: "The studio's keys" is "the-studios-keys".
QString headingAnchor(const QString& heading);

/// Says which page helps with a widget and all that is inside it: "reports.md", or with an anchor "studio.md#colors".
void setHelpPage(QWidget& widget, const QString& page);
/// The page of a widget, or of what it stands in; the guide's table where nothing says so.
QString helpPageOf(const QWidget* widget);

} // namespace mirrorball::studio
