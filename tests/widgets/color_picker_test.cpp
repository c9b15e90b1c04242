#include "color_picker_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "widgets/controls/color_button.h"
#include "widgets/controls/color_parts.h"
#include "widgets/controls/color_picker.h"
#include "widgets/controls/number_field.h"

#include <QLineEdit>
#include <QToolButton>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<ColorPickerTest> registered;

void ColorPickerTest::init() { QSettings().clear(); }

namespace {

bool isNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance)
{
    return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance && std::abs(a.b - b.b) <= tolerance;
}

/// A window with the swatch of the diffuse color handed to the picker.
struct Picking {
    StudioWindow window;
    ColorButton* swatch;
    ColorPicker* picker;

    Picking()
    {
        window.show();
        swatch = window->findChild<ColorButton*>(QStringLiteral("material.diffuse.color"));
        picker = window->findChild<ColorPicker*>();
        QTest::mouseClick(swatch, Qt::LeftButton);
        QTest::qWait(50);
    }
    const glm::dvec3& color() { return window.document().scene().material.diffuse.color; }
    template <typename Control>
    Control* control(const char* name)
    {
        return picker->findChild<Control*>(QLatin1String(name));
    }
    void type(const char* name, const QString& text)
    {
        auto* number = control<NumberField>(name);
        number->box()->setFocus();
        number->box()->selectAll();
        QTest::keyClicks(number->box(), text + u'\r');
    }
};

} // namespace

// ---- numbers -------------------------------------------------------------------------------------------------------------------

void ColorPickerTest::partsMakeTheColorAgain()
{
    for (const glm::dvec3& color : {glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(0.2, 0.5, 0.03), glm::dvec3(8.0, 2.0, 0.5)}) {
        const ColorParts parts = colorParts(color);
        // QColor holds 16 bits a channel: half a step of them, where sRGB is steepest, and five digits
        QVERIFY(isNear(linearColor(parts), color, (2.5 * 0.5 / 65535.0) * std::exp2(parts.ev) + 1e-5));
    }
    QCOMPARE(colorParts({8.0, 2.0, 0.5}).ev, 3.0);
    QCOMPARE(colorParts({0.5, 0.2, 0.5}).ev, 0.0);
}

void ColorPickerTest::hexIsReadAndWritten()
{
    QCOMPARE(hexText(colorParts({1.0, 0.0, 0.0})), QStringLiteral("#ff0000"));
    QCOMPARE(colorOfHex(QStringLiteral("#ff8000")), std::optional(QColor(255, 128, 0)));
    QCOMPARE(colorOfHex(QStringLiteral(" 0f8 ")), std::optional(QColor(0, 255, 136)));
    for (const char* wrong : {"", "#ff80", "red", "#gg0000", "#ff800000"})
        QVERIFY2(!colorOfHex(QLatin1String(wrong)), wrong);
}

// Charity's table of black bodies (10 degrees, 2001), sRGB: 2000 K #ff8912, 4000 K #ffcea6, 10000 K #ccdbff.
void ColorPickerTest::blackBodiesAreWhereTablesHaveThem()
{
    const struct {
        double kelvin;
        QColor table;
    } rows[] = {{2000.0, QColor(0xff, 0x89, 0x12)}, {4000.0, QColor(0xff, 0xce, 0xa6)}, {10000.0, QColor(0xcc, 0xdb, 0xff)}};
    for (const auto& [kelvin, table] : rows) {
        const QColor ours = colorParts(blackBody(kelvin)).shown;
        for (const auto& [a, b] :
             {std::pair{ours.red(), table.red()}, std::pair{ours.green(), table.green()}, std::pair{ours.blue(), table.blue()}})
            QVERIFY2(std::abs(a - b) <= 14, qPrintable(QStringLiteral("%1 K is %2").arg(kelvin).arg(ours.name()))); // other observers
    }
}

// ---- the dock ------------------------------------------------------------------------------------------------------------------

void ColorPickerTest::aClickOnASwatchBringsThePicker()
{
    Picking p;
    QTRY_VERIFY(p.picker->isVisible());
    QVERIFY(p.picker->isEnabled());
    QCOMPARE(p.picker->target(), p.swatch);
    QVERIFY(p.window->dock(QStringLiteral("material"))->widget()->isVisible()); // the swatch stays in sight
    QVERIFY(unexplained(*p.picker).isEmpty());
    auto* hex = p.control<QLineEdit>("color.hex");
    hex->setFocus();
    hex->selectAll();
    QTest::keyClicks(hex, QStringLiteral("#0000ff\r"));
    QCOMPARE(p.color(), glm::dvec3(0.0, 0.0, 1.0));
    p.window.waitForPicture();
    keepScreenshot(*p.window, QStringLiteral("color-picker"));
}

void ColorPickerTest::theWheelChoosesAndADragIsOneStep()
{
    Picking p;
    p.type("color.value", QStringLiteral("100"));
    auto* wheel = p.control<QWidget>("color.wheel");
    QTRY_VERIFY(wheel->isVisible());
    const int before = p.window.document().undoStack().index();
    const QPoint middle = wheel->rect().center();
    const int radius = std::min(wheel->width(), wheel->height()) / 2 - 4;
    Painting::drag(wheel, middle, middle + QPoint(radius + 20, 0)); // beyond the rim: the rim, which is red there
    QCOMPARE(p.window.document().undoStack().index(), before + 1);
    QVERIFY2(isNear(p.color(), {1.0, 0.0, 0.0}, 0.03), qPrintable(hexText(colorParts(p.color()))));
    wheel->setFocus();
    for (int i = 0; i < 24; ++i)
        QTest::keyClick(wheel, Qt::Key_Left); // a third of a turn: green
    QVERIFY2(isNear(p.color(), {0.0, 1.0, 0.0}, 0.03), qPrintable(hexText(colorParts(p.color()))));
}

void ColorPickerTest::intensityGoesAboveOne()
{
    Picking p;
    auto* hex = p.control<QLineEdit>("color.hex");
    hex->setFocus();
    hex->selectAll();
    QTest::keyClicks(hex, QStringLiteral("#ffffff\r"));
    p.type("color.ev", QStringLiteral("3"));
    QCOMPARE(p.color(), glm::dvec3(8.0));
    QCOMPARE(hex->text(), QStringLiteral("#ffffff"));
    p.type("color.kelvin", QStringLiteral("2000")); // keeps the intensity
    QCOMPARE(p.color().r, 8.0);
    QVERIFY(p.color().b < 0.5);
}

void ColorPickerTest::followsUndoAndWhatIsChosen()
{
    Picking p;
    const glm::dvec3 first = p.color();
    p.type("color.value", QStringLiteral("50"));
    const glm::dvec3 second = p.color();
    QVERIFY(first != second);
    p.window.document().undoStack().undo();
    QCOMPARE(p.picker->color(), first);
    auto* other = p.window->findChild<ColorButton*>(QStringLiteral("material.specular.color"));
    QTest::mouseClick(other, Qt::LeftButton);
    QCOMPARE(p.picker->target(), other);
    p.type("color.value", QStringLiteral("25"));
    QCOMPARE(p.color(), first); // is left alone
    QVERIFY(p.window.document().scene().material.specular.color != glm::dvec3(1.0));
}

void ColorPickerTest::keepsSwatchesAndRecentOnes()
{
    {
        Picking p;
        p.type("color.value", QStringLiteral("50"));
        p.type("color.value", QStringLiteral("75"));
        QCOMPARE(ColorPicker::recentColors().size(), 2);
        QCOMPARE(ColorPicker::recentColors().front(), p.color());
        QTest::mouseClick(p.control<QToolButton>("color.keep"), Qt::LeftButton);
        QCOMPARE(ColorPicker::keptColors(), QVector<glm::dvec3>{p.color()});
    }
    Picking again;
    auto* kept = again.control<QToolButton>("color.kept");
    QVERIFY(kept);
    QTest::mouseClick(kept, Qt::LeftButton);
    QCOMPARE(again.color(), ColorPicker::keptColors().front());
}

void ColorPickerTest::picksFromTheScreen()
{
    Picking p;
    QWidget plain; // something of this screen with a color of its own
    plain.setStyleSheet(QStringLiteral("background: #ff0000"));
    plain.setGeometry(1500, 700, 200, 200);
    plain.show();
    QVERIFY(QTest::qWaitForWindowExposed(&plain));
    QTest::mouseClick(p.control<QToolButton>("color.dropper"), Qt::LeftButton);
    const QPoint at = plain.mapToGlobal(QPoint(100, 100));
    QMouseEvent press(QEvent::MouseButtonPress, p.picker->mapFromGlobal(at), at, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(p.picker, &press); // which has the mouse
    QCOMPARE(p.color(), glm::dvec3(1.0, 0.0, 0.0));
}

} // namespace mirrorball::test
