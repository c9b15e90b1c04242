#include "main_window_test.h"

#include "studio_window.h"

#include "app/studio/command_palette.h"
#include "app/studio/docks.h"
#include "core/scene/scene_file.h"
#include "widgets/controls/text.h"
#include "widgets/files/recent_files.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QProcess>
#include <QScrollBar>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

#include <functional>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<MainWindowTest> registered;

static void runCommandLine(const QStringList& arguments)
{
    QProcess program;
    program.start(QStringLiteral(MIRRORBALL_PROGRAM), arguments);
    QVERIFY(program.waitForFinished(120000));
    QVERIFY2(program.exitCode() == 0, program.readAllStandardError().constData());
}

static bool hasNotice(StudioWindow& window, const QString& subject, const QString& word)
{
    for (const Notices::Notice& notice : window->workspace().notices.all())
        if (notice.subject == subject && notice.text.contains(word))
            return true;
    return false;
}

void MainWindowTest::init() { QSettings().clear(); }

// One renderer, two contexts: what the window shows is what the command line writes, but for the last bit of an 8-bit level.
void MainWindowTest::showsThePictureThatTheCommandLineDraws()
{
    const TemporaryFolder folder;
    StudioWindow window;
    window.document().edit(QStringLiteral("scene"), {}, [](Scene& scene) {
        scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 40};
        scene.view.geometry = "torus";
    });
    window.show();
    const QImage shown = window.picture();
    window.document().save(fromPath(folder / "a.mirrorball"));
    runCommandLine({QStringLiteral("render"), fromPath(folder / "a.mirrorball"), QStringLiteral("--size"),
                    QStringLiteral("%1x%2").arg(shown.width()).arg(shown.height()), QStringLiteral("-o"), fromPath(folder / "a.png")});
    const int difference = largestDifference(shown, QImage(fromPath(folder / "a.png")));
    QVERIFY2(difference <= 1, qPrintable(QString::number(difference)));
}

void MainWindowTest::savesThePictureThatTheCommandLineSaves()
{
    const TemporaryFolder folder;
    StudioWindow window;
    window.document().edit(QStringLiteral("scene"), {}, [](Scene& scene) {
        scene.view.width = 160;
        scene.view.height = 120;
    });
    window.document().save(fromPath(folder / "a.mirrorball"));
    for (const char* extension : {"png", "exr"}) {
        const std::filesystem::path ours = folder / (std::string("ours.") + extension),
                                    theirs = folder / (std::string("theirs.") + extension);
        window->savePicture(fromPath(ours));
        QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(ours), 60000);
        runCommandLine({QStringLiteral("render"), fromPath(folder / "a.mirrorball"), QStringLiteral("-o"), fromPath(theirs)});
        QVERIFY(readBytes(ours) == readBytes(theirs));
    }
}

void MainWindowTest::everyControlHasTooltipNameAndKeys()
{
    StudioWindow window;
    window.show();
    QStringList wanting;
    for (const QWidget* widget : window->findChildren<QWidget*>()) {
        const bool isControl = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
                               qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
                               qobject_cast<const QAbstractItemView*>(widget);
        const QString name = widget->objectName();
        const bool isInside = qobject_cast<const QScrollBar*>(widget) || name.startsWith(QStringLiteral("qt_")) ||
                              qobject_cast<const QComboBox*>(widget->parentWidget()) || widget->inherits("QComboBoxPrivateContainer") ||
                              widget->window() != &*window ||
                              (widget->parentWidget() && widget->parentWidget()->inherits("QComboBoxPrivateContainer"));
        if (!isControl || isInside || widget->inherits("QHeaderView") || qobject_cast<const QTabBar*>(widget->parentWidget()) ||
            widget->inherits("QTableCornerButton"))
            continue;
        const QString label = QStringLiteral("%1 '%2' in '%3'")
                                  .arg(QLatin1String(widget->metaObject()->className()), name,
                                       widget->parentWidget() ? widget->parentWidget()->objectName() : QString());
        const auto* button = qobject_cast<const QToolButton*>(widget);
        const QAction* action = button ? button->defaultAction() : nullptr; // reached through the menus
        if (widget->toolTip().isEmpty())
            wanting << label + QStringLiteral(": no tooltip");
        if (widget->accessibleName().isEmpty() && !action)
            wanting << label + QStringLiteral(": no accessible name");
        if (!action && !(widget->focusPolicy() & Qt::TabFocus) && !(button && !button->shortcut().isEmpty()) &&
            !widget->parentWidget()->inherits("QDockWidget"))
            wanting << label + QStringLiteral(": no way to it by keys");
    }
    for (const QAction* menu : window->menuBar()->actions())
        for (const QAction* action : menu->menu()->actions())
            if (!action->isSeparator() && action->toolTip().isEmpty())
                wanting << action->text() + QStringLiteral(": no tooltip");
    QVERIFY2(wanting.isEmpty(), qPrintable(wanting.join(u'\n')));
}

void MainWindowTest::oneKeyHidesAndShowsAllDocks()
{
    StudioWindow window;
    window.show();
    const auto shown = [&] {
        int count = 0;
        for (const DockEntry& entry : dockEntries())
            count += !window->dock(QLatin1String(entry.id))->isHidden();
        return count;
    };
    const int before = shown();
    QCOMPARE(before, static_cast<int>(dockEntries().size()));
    window.preview().setFocus();
    QTest::keyClick(&window.preview(), Qt::Key_Tab);
    QCOMPARE(shown(), 0);
    QTest::keyClick(&window.preview(), Qt::Key_Tab);
    QCOMPARE(shown(), before);
    QTest::keyClick(&*window, Qt::Key_F9);
    QCOMPARE(shown(), 0);
    QTest::keyClick(&*window, Qt::Key_F9);
    QCOMPARE(shown(), before);
}

// Whatever a command of the View menu changes of the scene is one step, and its undoing brings the scene back.
void MainWindowTest::everyCommandOfTheViewMenuCanBeUndone()
{
    StudioWindow window;
    window.show();
    QList<QAction*> commands;
    std::function<void(const QMenu&)> collect = [&](const QMenu& menu) {
        for (QAction* action : menu.actions())
            action->menu() ? collect(*action->menu()) : void(commands << action);
    };
    for (const QAction* menu : window->menuBar()->actions())
        if (menu->text() == QStringLiteral("&View"))
            collect(*menu->menu());
    const Scene start = [] {
        Scene scene; // where no command is without effect
        scene.view.geometry = "window";
        scene.view.camera.target = {1.0, 0.0, 0.0};
        return scene;
    }();
    int changing = 0;
    for (QAction* command : commands) {
        window.document().reset(start);
        if (!command->isEnabled() || command->isSeparator())
            continue;
        command->trigger();
        window.document().finishEdit();
        if (window.document().scene() == start)
            continue; // chosen already, or not of the scene
        ++changing;
        QCOMPARE(window.document().undoStack().count(), 1);
        window.document().undoStack().undo();
        QVERIFY2(window.document().scene() == start, qPrintable(command->text()));
        window.document().undoStack().redo();
        QVERIFY2(window.document().scene() != start, qPrintable(command->text()));
    }
    QCOMPARE(changing,
             20); // 4 of 5 bodies, 7 of 8 shadings, lookup, 1 of 2 projections, 3 of 4 backgrounds, frame, reset, brighter, darker
}

// A panel that nobody sees does no work; Qt itself counts a dock behind a tab as visible.
void MainWindowTest::aPanelBehindATabIsHidden()
{
    StudioWindow window;
    window.show();
    QDockWidget *plan = window->dock(QStringLiteral("plan")), *report = window->dock(QStringLiteral("report"));
    QTRY_VERIFY(plan->widget()->isVisible() && !report->widget()->isVisible());
    report->raise();
    QTRY_VERIFY(!plan->widget()->isVisible() && report->widget()->isVisible());
    plan->setFloating(true);
    QTRY_VERIFY(plan->widget()->isVisible());
    window->hideOrShowDocks();
    window->hideOrShowDocks();
    QTRY_VERIFY(plan->widget()->isVisible() && report->widget()->isVisible());
}

void MainWindowTest::keepsItsLayoutBetweenRuns()
{
    {
        StudioWindow window;
        window.show();
        window->dock(QStringLiteral("map"))->hide();
        window->dock(QStringLiteral("plan"))->setFloating(true);
        window->addDockWidget(Qt::LeftDockWidgetArea, window->dock(QStringLiteral("material")));
        window->close();
    }
    StudioWindow again;
    again.show();
    QVERIFY(again->dock(QStringLiteral("map"))->isHidden());
    QVERIFY(again->dock(QStringLiteral("plan"))->isFloating());
    QCOMPARE(again->dockWidgetArea(again->dock(QStringLiteral("material"))), Qt::LeftDockWidgetArea);
    again->resetLayout();
    QVERIFY(!again->dock(QStringLiteral("map"))->isHidden());
    QVERIFY(!again->dock(QStringLiteral("plan"))->isFloating());
}

void MainWindowTest::thePaletteFindsAndRunsCommands()
{
    QVERIFY(matchScore(QStringLiteral("geto"), QStringLiteral("View: Geometry: Torus")) > 0);
    QCOMPARE(matchScore(QStringLiteral("xyz"), QStringLiteral("View: Geometry: Torus")), 0);
    StudioWindow window;
    window.show();
    for (const Qt::KeyboardModifiers keys : {Qt::KeyboardModifiers(Qt::ControlModifier), Qt::ControlModifier | Qt::ShiftModifier}) {
        QTest::keyClick(&*window, Qt::Key_P, keys);
        auto* palette = window->findChild<CommandPalette*>();
        QVERIFY(palette);
        QTest::keyClicks(&palette->input(), QStringLiteral("torus"));
        QTest::keyClick(&palette->input(), Qt::Key_Return);
        QCOMPARE(window.document().scene().view.geometry, std::string("torus"));
        window.document().undoStack().undo();
        QTRY_VERIFY(!window->findChild<CommandPalette*>());
    }
}

void MainWindowTest::everyViewCommandCanBeUndone()
{
    StudioWindow window;
    window.show();
    window.document().edit(QStringLiteral("away"), {}, [](Scene& scene) { scene.view.camera.target.x = 0.2; });
    const Scene before = window.document().scene();
    int edits = 0;
    QList<QAction*> actions;
    for (QAction* action : window->findChildren<QAction*>())
        if (action->menu() == nullptr && action->isEnabled() && action->parent()->inherits("mirrorball::studio::ViewActions"))
            actions << action;
    for (QAction* action : actions) {
        action->trigger();
        window.document().finishEdit();
        if (window.document().scene() == before)
            continue;
        ++edits;
        window.document().undoStack().undo();
        QVERIFY2(window.document().scene() == before, qPrintable(action->text()));
    }
    QVERIFY2(edits >= 14,
             qPrintable(QString::number(edits))); // 3 bodies, 5 shadings, 1 projection, 3 backgrounds, frame, reset, 2 exposures
}

void MainWindowTest::aMissingProbeIsNamedAndAPlaceholderShown()
{
    StudioWindow window;
    window.show();
    window.document().edit(QStringLiteral("probe"), {}, [](Scene& scene) { scene.probe.source = "/nowhere/lost.hdr"; });
    QTRY_VERIFY_WITH_TIMEOUT(hasNotice(window, QStringLiteral("probe"), QStringLiteral("/nowhere/lost.hdr")), 30000);
    QVERIFY(window->isEnabled() && !QApplication::activeModalWidget());
    QTRY_VERIFY(window->findChild<QWidget*>(QStringLiteral("notices"))->isVisible());
    const QColor corner = window.picture().pixelColor(3, 3); // magenta or dark gray, of no other probe
    QVERIFY(corner.red() > corner.green() || corner.red() < 90);
    window.document().undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(!hasNotice(window, QStringLiteral("probe"), QString()), 30000);
}

void MainWindowTest::aMissingMeshIsNamedAndABoxShown()
{
    StudioWindow window;
    window.preview().setFixedSize(640, 360); // the notice's strip takes room from it
    window.show();
    window.document().edit(QStringLiteral("mesh"), {}, [](Scene& scene) { scene.view.geometry = "box"; });
    const QImage box = window.picture();
    window.document().edit(QStringLiteral("mesh"), {}, [](Scene& scene) { scene.view.geometry = "/nowhere/lost.obj"; });
    QTRY_VERIFY_WITH_TIMEOUT(hasNotice(window, QStringLiteral("mesh"), QStringLiteral("/nowhere/lost.obj")), 30000);
    QVERIFY(largestDifference(window.picture(), box) <= 1);
}

void MainWindowTest::unsavedChangesAreGuarded()
{
    const TemporaryFolder folder;
    saveScene({}, folder / "other.mirrorball");
    StudioWindow window;
    window.show();
    const auto answer = [](QMessageBox::StandardButton button) {
        QTimer::singleShot(0, qApp, [button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box)
                box->button(button)->click();
        });
    };
    const auto change = [&] { window.document().edit(QStringLiteral("change"), {}, [](Scene& scene) { scene.view.exposure += 1.0; }); };
    change();
    QVERIFY(window->isWindowModified());
    answer(QMessageBox::Cancel);
    QVERIFY(!window->close());
    answer(QMessageBox::Cancel);
    QVERIFY(!window->files().openScene(fromPath(folder / "other.mirrorball")));
    QVERIFY(window.document().filePath().isEmpty());
    answer(QMessageBox::Discard);
    QVERIFY(window->files().openScene(fromPath(folder / "other.mirrorball")));
    change();
    answer(QMessageBox::Save);
    QVERIFY(window->close());
    QCOMPARE(loadScene(folder / "other.mirrorball").view.exposure, 1.0);
}

void MainWindowTest::remembersRecentFiles()
{
    const TemporaryFolder folder;
    StudioWindow window;
    QVERIFY(window->files().saveAs(fromPath(folder / "one.mirrorball")));
    QVERIFY(window->files().saveAs(fromPath(folder / "two.mirrorball")));
    QVERIFY(window->files().openScene(fromPath(folder / "one.mirrorball")));
    QCOMPARE(recentFiles(), (QVector<RecentFile>{{fromPath(folder / "one.mirrorball"), FileKind::Scene},
                                                 {fromPath(folder / "two.mirrorball"), FileKind::Scene}}));
    QVERIFY(!window->files().openScene(fromPath(folder / "gone.mirrorball")));
    QVERIFY(hasNotice(window, QStringLiteral("file"), QStringLiteral("gone.mirrorball")));
}

} // namespace mirrorball::test
