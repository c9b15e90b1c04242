#include "translations_test.h"

#include "widgets/controls/field_texts.h"

#include <QFile>
#include <QSet>
#include <QXmlStreamReader>

namespace mirrorball::test {

static const RegisterTests<TranslationsTest> registered;

/// The source texts of a context in the file that translators get.
static QSet<QString> sources(const QString& context)
{
    QFile file(QStringLiteral(MIRRORBALL_TRANSLATIONS));
    QSet<QString> found;
    if (!file.open(QFile::ReadOnly))
        return found;
    QXmlStreamReader xml(&file);
    QString name;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement) {
            if (xml.name() == QStringLiteral("name"))
                name = xml.readElementText();
            else if (xml.name() == QStringLiteral("source") && name == context)
                found.insert(xml.readElementText());
        }
    return found;
}

// Forms are made of core's fields, whose words lupdate cannot see: `cmake --build build/ci --target update_translations` brings them in.
void TranslationsTest::wordsOfCoreAreThereToTranslate()
{
    const QSet<QString> known = sources(QStringLiteral("Fields"));
    QStringList wanting;
    for (const std::string& text : studio::fieldTexts())
        if (!known.contains(QString::fromStdString(text)))
            wanting << QString::fromStdString(text);
    QVERIFY2(wanting.isEmpty(), qPrintable(wanting.join(u'\n')));
}

} // namespace mirrorball::test
