#include "layout_test.h"

#include "studio_window.h"
#include "widget_driver.h"

#include "app/studio/command_palette.h"
#include "app/studio/docks.h"
#include "app/studio/preferences_dialog.h"
#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "core/image/map_file.h"
#include "support/temporary_folder.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/text.h"
#include "widgets/exports/export_dialog.h"
#include "widgets/files/doctor_dialog.h"
#include "widgets/files/picture_question.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<LayoutTest> registered;

void LayoutTest::init() { QSettings().clear(); }

namespace {

void choose(StudioWindow& window, const char* name, int index)
{
    auto* combo = window->findChild<QComboBox*>(QLatin1String(name));
    combo->setCurrentIndex(index);
    emit combo->activated(index);
    QTest::qWait(30); // the layout's own events
}

void showSized(StudioWindow& window, const QSize& size)
{
    window->resize(size);
    window.show();
    window->resize(size);
    QTest::qWait(100);
}

/// The window's size, and where each dock lies.
QVector<QRect> places(StudioWindow& window)
{
    QVector<QRect> all{QRect(QPoint(), window->size())};
    for (const DockEntry& entry : dockEntries())
        all << window->dock(QLatin1String(entry.id))->geometry();
    return all;
}

/// What a screen reader calls a control.
QString nameOf(QWidget& widget)
{
    auto* number = qobject_cast<NumberField*>(&widget);
    return number ? number->box()->accessibleName() : widget.accessibleName();
}

/// What has less width than it asks for, or lies beyond what its place shows or scrolls to.
QStringList cutParts(const QWidget& place, const QString& name)
{
    QStringList cut;
    for (const QWidget* widget : place.findChildren<QWidget*>()) {
        // The buttons of a dock's title, and those within a line of text, are Qt's.
        if (!widget->isVisible() || (widget->parentWidget() == &place && qobject_cast<const QDockWidget*>(&place)) ||
            qobject_cast<const QLineEdit*>(widget->parentWidget()))
            continue;
        const auto* label = qobject_cast<const QLabel*>(widget);
        const bool isWhole = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
                             qobject_cast<const NumberField*>(widget) || (label && !label->wordWrap());
        const QSize least = widget->minimumSizeHint();
        if (isWhole && (widget->width() < least.width() || widget->height() < least.height()))
            cut << QStringLiteral("%1: %2 '%3' has %4 x %5 of %6 x %7 pixels")
                       .arg(name, QLatin1String(widget->metaObject()->className()), widget->accessibleName())
                       .arg(widget->width())
                       .arg(widget->height())
                       .arg(least.width())
                       .arg(least.height());
        if (const auto* scroll = qobject_cast<const QScrollArea*>(widget);
            scroll && scroll->widget() && scroll->widget()->width() > scroll->viewport()->width())
            cut << QStringLiteral("%1: its content is %2 wide in %3")
                       .arg(name)
                       .arg(scroll->widget()->width())
                       .arg(scroll->viewport()->width());
    }
    return cut;
}

QString stateText(StudioWindow& window) { return window->findChild<QLabel*>(QStringLiteral("workState"))->text(); }

} // namespace

// ---- sizes ---------------------------------------------------------------------------------------------------------------------

void LayoutTest::choosingChangesNoSize_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("1440 x 900") << QSize(1440, 900);
    QTest::newRow("1024 x 640") << QSize(1024, 640);
}

void LayoutTest::choosingChangesNoSize()
{
    QFETCH(QSize, size);
    StudioWindow window;
    showSized(window, size);
    const QVector<QRect> before = places(window);
    for (const char* list : {"map.parameterization", "map.compare", "map.tint", "map.colors"}) {
        const int count = window->findChild<QComboBox*>(QLatin1String(list))->count();
        for (int i = count - 1; i >= 0; --i) { // back to the first
            choose(window, list, i);
            QVERIFY2(places(window) == before, qPrintable(QStringLiteral("%1, item %2").arg(QLatin1String(list)).arg(i)));
        }
    }
    for (const char* list : {"material.fresnel.kind", "material.specular.lobe"})
        for (int i = 0; i < window->findChild<QComboBox*>(QLatin1String(list))->count(); ++i) {
            choose(window, list, i);
            QVERIFY2(places(window) == before, list);
        }
    window->workspace().sphereMap.setMap(QStringLiteral("map"), SphereMapDocument{.layers = {Layer{.content = PaintLayer{}}}});
    QTest::qWait(50);
    QVERIFY(places(window) == before);
}

void LayoutTest::nothingIsCutOnASmallScreen_data() { choosingChangesNoSize_data(); }

// Texts and controls have the width that they ask for, and lie inside of what their dock shows or scrolls to.
void LayoutTest::nothingIsCutOnASmallScreen()
{
    QFETCH(QSize, size);
    StudioWindow window;
    showSized(window, size);
    QCOMPARE(window->size(), size);
    QVERIFY2(window.preview().width() >= size.width() / 4 && window.preview().height() >= size.height() / 4,
             qPrintable(QStringLiteral("%1 x %2").arg(window.preview().width()).arg(window.preview().height())));
    QStringList cut;
    for (const DockEntry& entry : dockEntries()) {
        QDockWidget* dock = window->dock(QLatin1String(entry.id));
        dock->raise();
        QTRY_VERIFY(dock->widget()->isVisible());
        QTest::qWait(50);
        keepScreenshot(*window, QStringLiteral("dock-%1-%2").arg(QLatin1String(entry.id)).arg(size.width()));
        cut << cutParts(*dock, QLatin1String(entry.id));
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
}

void LayoutTest::dialogsAreWhole_data() { choosingChangesNoSize_data(); }

// Each dialog fits the screen at the size it takes by itself, and nothing in it is cut.
void LayoutTest::dialogsAreWhole()
{
    QFETCH(QSize, size);
    const TemporaryFolder folder;
    Image ball(48, 48, 3);
    std::fill(ball.texels.begin(), ball.texels.end(), 0.5f);
    writeImage(folder / "ball.png", ball);
    writeMap(folder / "map.exr", {renderBuiltinProbe("sky", {Parameterization::Cube, 16, 0})});
    StudioWindow window;
    showSized(window, size);
    window.waitForPicture();
    window->findChild<QAction*>(QStringLiteral("file.export"))->trigger();
    auto* exports = window->findChild<ExportDialog*>();
    QVERIFY(exports && QTest::qWaitFor([&] { return exports->isEstimated(); }, 60000));
    auto* doctor = new DoctorDialog(window->workspace(), QString::fromStdString((folder / "map.exr").string()), &*window);
    auto* question = new PictureQuestion(window->workspace(), QString::fromStdString((folder / "ball.png").string()), &*window);
    doctor->show();
    question->show();
    QTRY_VERIFY_WITH_TIMEOUT(!doctor->text().isEmpty() && !question->cards().isEmpty(), 60000);
    window->findChild<QAction*>(QStringLiteral("edit.preferences"))->trigger();
    window->findChild<QAction*>(QStringLiteral("edit.palette"))->trigger();
    QStringList cut;
    const QMap<QString, QWidget*> dialogs{{QStringLiteral("export"), exports},
                                          {QStringLiteral("doctor"), doctor},
                                          {QStringLiteral("question"), question},
                                          {QStringLiteral("preferences"), window->findChild<PreferencesDialog*>()},
                                          {QStringLiteral("palette"), window->findChild<CommandPalette*>()}};
    for (auto dialog = dialogs.begin(); dialog != dialogs.end(); ++dialog) {
        QWidget& shown = *dialog.value();
        QTRY_VERIFY(shown.isVisible());
        const QSize smallest = shown.minimumSizeHint().expandedTo(shown.minimumSize());
        if (smallest.width() > size.width() || smallest.height() > size.height())
            cut << QStringLiteral("%1: asks for %2 x %3").arg(dialog.key()).arg(smallest.width()).arg(smallest.height());
        shown.resize(shown.size().boundedTo(size));
        QTest::qWait(50);
        keepScreenshot(shown, QStringLiteral("dialog-%1-%2").arg(dialog.key()).arg(size.width()));
        cut << cutParts(shown, dialog.key());
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
}

void LayoutTest::whatTheBarHasNoRoomForIsInAMenu()
{
    StudioWindow window;
    showSized(window, {1024, 640});
    auto* bar = window->findChild<QToolBar*>(QStringLiteral("pictureBar"));
    auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    QVERIFY(more);
    QTRY_VERIFY(more->isVisible()); // there is less room than commands
    QVERIFY(more->width() >= 16);
    const QImage picture = more->grab().toImage();
    int light = 0; // it can be seen: some of it stands out from the bar
    const int ground = bar->grab().toImage().pixelColor(1, 1).lightness();
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            light += picture.pixelColor(x, y).lightness() > ground + 60;
    QVERIFY2(light >= 8, qPrintable(QString::number(light)));
}

// ---- keys ----------------------------------------------------------------------------------------------------------------------

void LayoutTest::keysRaiseATabThatLiesBehind()
{
    StudioWindow window;
    window.show();
    QDockWidget *material = window->dock(QStringLiteral("material")), *view = window->dock(QStringLiteral("view"));
    QTRY_VERIFY(material->widget()->isVisible() && !view->widget()->isVisible());
    QTest::keyClick(&*window, Qt::Key_3, Qt::AltModifier); // View is the third dock
    QTRY_VERIFY(view->widget()->isVisible() && !material->widget()->isVisible());
    QVERIFY(!view->isHidden());
    QTest::keyClick(&*window, Qt::Key_2, Qt::AltModifier);
    QTRY_VERIFY(material->widget()->isVisible());
    QTest::keyClick(&*window, Qt::Key_2, Qt::AltModifier); // what is seen, closes
    QVERIFY(material->isHidden());
    QVERIFY(!window->findChild<QAction*>(QStringLiteral("window.material"))->isChecked());
    QTest::keyClick(&*window, Qt::Key_2, Qt::AltModifier);
    QTRY_VERIFY(material->widget()->isVisible());
    QVERIFY(window->findChild<QAction*>(QStringLiteral("window.material"))->isChecked());
}

void LayoutTest::keysOutsideThePictureChangeNothing()
{
    StudioWindow window;
    window.show();
    QWidget* const spots[] = {window->findChild<QListView*>(QStringLiteral("probes.list")),
                              window->findChild<QWidget*>(QStringLiteral("map.view"))};
    const Scene before = window.document().scene();
    for (QWidget* place : spots) {
        place->setFocus();
        for (const Qt::Key key : {Qt::Key_2, Qt::Key_3, Qt::Key_E, Qt::Key_F, Qt::Key_R, Qt::Key_W, Qt::Key_D})
            QTest::keyClick(place, key);
        window.document().finishEdit();
        QVERIFY2(window.document().scene() == before, qPrintable(place->objectName()));
    }
}

void LayoutTest::aKeyOnThePictureSaysWhatItDid()
{
    StudioWindow window;
    window.show();
    QVERIFY(window.preview().hasFocus()); // at first the keys are the picture's
    QTest::keyClick(&window.preview(), Qt::Key_2);
    QCOMPARE(window.document().scene().view.shading, Shading::Wireframe);
    QVERIFY2(window->statusBar()->currentMessage().contains(QStringLiteral("Wireframe")),
             qPrintable(window->statusBar()->currentMessage()));
    QTest::keyClick(&window.preview(), Qt::Key_E);
    QVERIFY2(window->statusBar()->currentMessage().contains(QStringLiteral("0.5 EV")), qPrintable(window->statusBar()->currentMessage()));
}

void LayoutTest::exposureHasAWayBack()
{
    StudioWindow window;
    window.show();
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&window.preview(), Qt::Key_E);
    window.document().finishEdit();
    QCOMPARE(window.document().scene().view.exposure, 1.5);
    QTest::keyClick(&window.preview(), Qt::Key_0);
    QCOMPARE(window.document().scene().view.exposure, 0.0);
    window.document().undoStack().undo();
    QCOMPARE(window.document().scene().view.exposure, 1.5);
}

// ---- the picture ---------------------------------------------------------------------------------------------------------------

void LayoutTest::upToDateIsSaidWhenThePictureIs()
{
    StudioWindow window;
    window.show();
    QTRY_VERIFY_WITH_TIMEOUT(stateText(window).startsWith(QStringLiteral("Up to date")), 30000);
    for (int change = 0; change < 4; ++change) {
        window.document().edit(QStringLiteral("change"), {}, [&](Scene& scene) {
            if (change % 2 == 0)
                scene.view.camera.yawDeg += 10.0; // a redraw
            else
                scene.map.size += 64; // and maps
        });
        QElapsedTimer clock;
        clock.start();
        while (!(window->workspace().live.isUpToDate() && window.preview().isUpToDate()) && clock.elapsed() < 60000) {
            QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
            const bool isCurrent = window->workspace().live.isUpToDate() && window.preview().isUpToDate();
            QVERIFY2(isCurrent || !stateText(window).startsWith(QStringLiteral("Up to date")), qPrintable(QString::number(change)));
        }
        QTRY_VERIFY(stateText(window).startsWith(QStringLiteral("Up to date")));
    }
}

// While the picture of a wider window is on its way, the one that is there stays as it is, in the middle.
void LayoutTest::aFrameOfAnotherSizeIsNotStretched()
{
    StudioWindow window;
    window.preview().setFixedSize(400, 400);
    window.show();
    const QImage before = window.picture();
    QCOMPARE(before.size(), QSize(400, 400));
    window.preview().setMinimumSize(0, 0);
    window.preview().setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
    window.preview().resize(800, 400);
    QImage shown(800, 400, QImage::Format_RGB888);
    window.preview().render(&shown); // at once, before another picture can come
    QVERIFY(largestDifference(shown.copy(200, 0, 400, 400), before) <= 1);
}

// ---- words ---------------------------------------------------------------------------------------------------------------------

void LayoutTest::aMaterialThatIsReplacedSaysSo()
{
    StudioWindow window;
    window.show();
    auto* note = window->findChild<QWidget*>(QStringLiteral("material.replaced"));
    QVERIFY(note && !note->isVisible());
    window.document().edit(QStringLiteral("map"), {}, [](Scene& scene) { scene.material.sphereMap.source = "toon-hero"; });
    QVERIFY(note->isVisible());
    window.waitForPicture();
    keepScreenshot(*window, QStringLiteral("material-replaced"));
    QTest::mouseClick(note->findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(window.document().scene().material.sphereMap.use, SphereMapUse::Over);
    QVERIFY(!note->isVisible());
    window.document().edit(QStringLiteral("map"), {}, [](Scene& scene) { scene.material.sphereMap.source.clear(); });
    QVERIFY(!note->isVisible());
}

// One field has one name wherever it is shown, and one name is one field's among those that are seen at the same time.
void LayoutTest::oneThingHasOneWord()
{
    StudioWindow window;
    window.show();
    QHash<QString, QString> names;
    QStringList wrong;
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        const QString path = widget->objectName(), name = nameOf(*widget);
        if (name.isEmpty() ||
            !(path.startsWith(u"probe.") || path.startsWith(u"view.") || path.startsWith(u"map.") || path.startsWith(u"material.")))
            continue;
        if (names.contains(path) && names[path] != name)
            wrong << QStringLiteral("%1 is '%2' and '%3'").arg(path, names[path], name);
        names[path] = name;
    }
    QVERIFY(names.size() > 40);
    QStringList exposures;
    for (const QString& name : names)
        if (name == QStringLiteral("Exposure"))
            exposures << name;
    QCOMPARE(exposures.size(), 1); // the picture's
    for (const QWidget* widget : window->findChildren<QWidget*>())
        for (const QString& text : {widget->accessibleName(), widget->property("text").toString()})
            if (text.contains(QStringLiteral("colour"), Qt::CaseInsensitive))
                wrong << text;
    for (const QAction* action : window->findChildren<QAction*>())
        if (action->text().contains(QStringLiteral("colour"), Qt::CaseInsensitive))
            wrong << action->text();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

} // namespace mirrorball::test
