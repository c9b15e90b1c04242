#include "guide.h"

#include <QFile>
#include <QRegularExpression>
#include <QWidget>

namespace mirrorball::studio {

namespace {

constexpr const char* pageProperty = "helpPage";
const QString tableOfPages = QStringLiteral("README.md");

QString titleOf(const QString& text)
{
    const QString first = text.section(u'\n', 0, 0);
    return first.startsWith(u'#') ? first.mid(1).trimmed() : first;
}

QVector<GuidePage> readPages()
{
    const QString table = guideText(tableOfPages);
    QVector<GuidePage> pages{{tableOfPages, titleOf(table)}};
    static const QRegularExpression row(QStringLiteral(R"(^\| \[([^\]]+)\]\(([\w-]+\.md)\))"), QRegularExpression::MultilineOption);
    for (auto rows = row.globalMatch(table); rows.hasNext();) {
        const QRegularExpressionMatch match = rows.next();
        pages.push_back({match.captured(2), match.captured(1)});
    }
    return pages;
}

} // namespace

const QVector<GuidePage>& guidePages()
{
    static const QVector<GuidePage> pages = readPages();
    return pages;
}

QString guideText(const QString& file)
{
    QFile page(QStringLiteral(":/docs/") + file);
    return page.open(QFile::ReadOnly) ? QString::fromUtf8(page.readAll()) : QString();
}

QString headingAnchor(const QString& heading)
{
    QString anchor;
    for (const QChar c : heading.toLower()) {
        if (c.isLetterOrNumber() || c == u'-' || c == u'_')
            anchor += c;
        else if (c.isSpace())
            anchor += u'-';
    }
    return anchor;
}

void setHelpPage(QWidget& widget, const QString& page) { widget.setProperty(pageProperty, page); }

QString helpPageOf(const QWidget* widget)
{
    for (const QWidget* at = widget; at; at = at->parentWidget())
        if (const QString page = at->property(pageProperty).toString(); !page.isEmpty())
            return page;
    return tableOfPages;
}

} // namespace mirrorball::studio
