#include "preferences_test.h"

#include "studio_window.h"
#include "widget_driver.h"

#include "app/studio/preferences_dialog.h"
#include "widgets/controls/number_field.h"

#include <QComboBox>
#include <QFileInfo>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolBar>
#include <QTreeWidget>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<PreferencesTest> registered;

void PreferencesTest::init() { QSettings().clear(); }

namespace {

PreferencesDialog& openPreferences(StudioWindow& window)
{
    QApplication::setActiveWindow(&*window);
    QTest::keyClick(&*window, Qt::Key_Comma, Qt::ControlModifier);
    auto* dialog = window->findChild<PreferencesDialog*>();
    if (!dialog)
        qFatal("the dialog did not open");
    QApplication::setActiveWindow(dialog);
    return *dialog;
}

QAction& command(StudioWindow& window, const char* name) { return *window->findChild<QAction*>(QLatin1String(name)); }

/// Chooses a command in the list and presses a key in the field.
void give(PreferencesDialog& dialog, const QString& title, Qt::Key key, Qt::KeyboardModifiers modifiers = {})
{
    auto& list = *dialog.findChild<QTreeWidget*>(QStringLiteral("preferences.commands"));
    const auto found = list.findItems(title, Qt::MatchExactly);
    QVERIFY2(found.size() == 1, qPrintable(title));
    list.setCurrentItem(found.front());
    auto& edit = *dialog.findChild<QKeySequenceEdit*>(QStringLiteral("preferences.key"));
    edit.setFocus();
    QSignalSpy taken(&edit, &QKeySequenceEdit::editingFinished);
    QTest::keyClick(&edit, key, modifiers);
    QVERIFY(taken.wait(10000)); // a second after the key is up, for another one may follow
}

QPushButton& button(PreferencesDialog& dialog, const QString& text)
{
    for (QPushButton* each : dialog.findChildren<QPushButton*>())
        if (each->text().remove(u'&') == text)
            return *each;
    qFatal("there is no such button");
}

void drag(QWidget& widget, Qt::MouseButton pressed, Qt::KeyboardModifiers keys, const QPoint& from, const QPoint& to)
{
    QTest::mousePress(&widget, pressed, keys, from);
    QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, pressed, keys);
    QApplication::sendEvent(&widget, &move);
    QTest::mouseRelease(&widget, pressed, keys, to);
}

} // namespace

void PreferencesTest::aCommandGetsAnotherKeyAndKeepsIt()
{
    {
        StudioWindow window;
        window.show();
        PreferencesDialog& dialog = openPreferences(window);
        keepScreenshot(dialog, QStringLiteral("preferences-keys"));
        give(dialog, QStringLiteral("Keep a snapshot"), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(command(window, "compare.snapshot").shortcut(), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M));
        QVERIFY(command(window, "compare.snapshot").toolTip().endsWith(QStringLiteral("(Ctrl+Shift+M)")));
        dialog.close();
        QApplication::setActiveWindow(&*window);
        QTest::keyClick(&*window, Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(window->workspace().snapshots.all().size(), size_t(1));
        QTest::keyClick(&*window, Qt::Key_K, Qt::ControlModifier); // does nothing any more
        QCOMPARE(window->workspace().snapshots.all().size(), size_t(1));
        QCOMPARE(window.document().undoStack().count(), 0);
    }
    StudioWindow again;
    again.show();
    QTest::keyClick(&*again, Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(again->workspace().snapshots.all().size(), size_t(1));
}

void PreferencesTest::aKeyThatIsTakenStaysWhereItIs()
{
    StudioWindow window;
    window.show();
    PreferencesDialog& dialog = openPreferences(window);
    give(dialog, QStringLiteral("Frame the object"), Qt::Key_K, Qt::ControlModifier);
    QCOMPARE(command(window, "view.frame").shortcut(), QKeySequence(Qt::Key_F));
    QCOMPARE(command(window, "compare.snapshot").shortcut(), QKeySequence(Qt::CTRL | Qt::Key_K));
    const QString problem = dialog.findChild<QLabel*>(QStringLiteral("preferences.problem"))->text();
    QVERIFY2(problem.contains(QStringLiteral("Ctrl+K")) && problem.contains(QStringLiteral("Keep a snapshot")), qPrintable(problem));
}

// A letter that is typed in a list looks an entry up there: it runs no command.
void PreferencesTest::aPlainKeyWorksOnThePictureAlone()
{
    StudioWindow window;
    window.show();
    PreferencesDialog& dialog = openPreferences(window);
    give(dialog, QStringLiteral("Hide or show all docks"), Qt::Key_Q);
    dialog.close();
    QApplication::setActiveWindow(&*window);
    auto* list = window->findChild<QListView*>(QStringLiteral("probes.list"));
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Q);
    QVERIFY(window->dock(QStringLiteral("probes"))->isVisible());
    window.preview().setFocus();
    QTest::keyClick(&window.preview(), Qt::Key_Q);
    QVERIFY(!window->dock(QStringLiteral("probes"))->isVisible());
}

void PreferencesTest::keysAreResetOneByOneAndAll()
{
    StudioWindow window;
    window.show();
    PreferencesDialog& dialog = openPreferences(window);
    give(dialog, QStringLiteral("Wipe"), Qt::Key_F5);
    give(dialog, QStringLiteral("Difference"), Qt::Key_F6);
    QTest::mouseClick(&button(dialog, QStringLiteral("Reset")), Qt::LeftButton); // the one that is chosen
    QCOMPARE(command(window, "compare.difference").shortcut(), QKeySequence(Qt::Key_D));
    QCOMPARE(command(window, "compare.wipe").shortcut(), QKeySequence(Qt::Key_F5));
    QTest::mouseClick(&button(dialog, QStringLiteral("No key")), Qt::LeftButton);
    QVERIFY(command(window, "compare.difference").shortcut().isEmpty());
    give(dialog, QStringLiteral("Redo"), Qt::Key_F7);
    QTest::mouseClick(&button(dialog, QStringLiteral("Reset all")), Qt::LeftButton);
    QCOMPARE(command(window, "compare.difference").shortcut(), QKeySequence(Qt::Key_D));
    QCOMPARE(command(window, "compare.wipe").shortcut(), QKeySequence(Qt::Key_W));
    QVERIFY(command(window, "edit.redo").shortcuts().size() >= 2); // all that it had
    dialog.close();
    QApplication::setActiveWindow(&*window);
    window->workspace().snapshots.keep(window->workspace().live.made(), {});
    window.preview().setFocus();
    QTest::keyClick(&window.preview(), Qt::Key_W);
    QCOMPARE(window.preview().comparison(), Comparison::Wipe);
}

void PreferencesTest::commandsAreFound()
{
    StudioWindow window;
    window.show();
    PreferencesDialog& dialog = openPreferences(window);
    auto& list = *dialog.findChild<QTreeWidget*>(QStringLiteral("preferences.commands"));
    const int all = list.topLevelItemCount();
    QVERIFY2(all > 40, qPrintable(QString::number(all)));
    QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("preferences.find")), QStringLiteral("snapshot"));
    QVERIFY(list.topLevelItemCount() >= 2 && list.topLevelItemCount() < all);
}

void PreferencesTest::aMousePresetMovesTheCamera_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<int>("pressed");
    QTest::addColumn<int>("keys");
    QTest::addColumn<QString>("does");
    const auto row = [](const char* preset, Qt::MouseButton pressed, Qt::KeyboardModifiers keys, const char* does) {
        QTest::addRow("%s %d %d", preset, int(pressed), int(keys))
            << QString::fromLatin1(preset) << int(pressed) << int(keys) << QString::fromLatin1(does);
    };
    row("mirrorball", Qt::LeftButton, {}, "Orbit");
    row("mirrorball", Qt::LeftButton, Qt::AltModifier, "Orbit");
    row("mirrorball", Qt::MiddleButton, {}, "Pan");
    row("alt", Qt::LeftButton, Qt::AltModifier, "Orbit");
    row("alt", Qt::MiddleButton, Qt::AltModifier, "Pan");
    row("alt", Qt::RightButton, Qt::AltModifier, "Zoom");
    row("alt", Qt::LeftButton, {}, "");
    row("middle", Qt::MiddleButton, {}, "Orbit");
    row("middle", Qt::MiddleButton, Qt::ShiftModifier, "Pan");
    row("middle", Qt::MiddleButton, Qt::ControlModifier, "Zoom");
    row("middle", Qt::LeftButton, {}, "");
    row("middle", Qt::RightButton, Qt::ShiftModifier, "Turn the environment");
}

void PreferencesTest::aMousePresetMovesTheCamera()
{
    QFETCH(QString, preset);
    QFETCH(int, pressed);
    QFETCH(int, keys);
    QFETCH(QString, does);
    {
        StudioWindow window;
        window.show();
        PreferencesDialog& dialog = openPreferences(window);
        auto& choice = *dialog.findChild<QComboBox*>(QStringLiteral("preferences.mouse"));
        for (size_t i = 0; i < mousePresets.size(); ++i)
            if (preset == QLatin1String(mousePresets[i].id)) {
                choice.setCurrentIndex(static_cast<int>(i));
                emit choice.activated(static_cast<int>(i));
            }
        QVERIFY(window->findChild<QAction*>(QStringLiteral("mouse.") + preset)->isChecked());
        dialog.close();
    }
    StudioWindow window; // the next run knows
    window.show();
    drag(window.preview(), static_cast<Qt::MouseButton>(pressed), Qt::KeyboardModifiers(keys), {100, 100}, {140, 90});
    QCOMPARE(window.document().undoStack().undoText(), does);
    QVERIFY(!window.document().isDragging());
    if (does == QStringLiteral("Zoom"))
        QVERIFY(window.document().scene().view.camera.distance < Scene{}.view.camera.distance); // to the right and up: nearer
}

void PreferencesTest::theWipesLineIsDraggedWhateverThePreset()
{
    StudioWindow window;
    window.show();
    window->findChild<QAction*>(QStringLiteral("mouse.middle"))->trigger();
    window.preview().takeSnapshot();
    window.preview().setComparison(Comparison::Wipe);
    const QPoint line(window.preview().width() / 2, 60);
    drag(window.preview(), Qt::LeftButton, {}, line, line + QPoint(80, 0));
    QVERIFY(window.preview().wipe() > 0.55);
}

void PreferencesTest::unsavedChangesAreKeptWhenItIsSaid()
{
    StudioWindow window;
    window.show();
    PreferencesDialog& dialog = openPreferences(window);
    auto& seconds = *dialog.findChild<QSpinBox*>(QStringLiteral("preferences.autosave"));
    QCOMPARE(seconds.value(), 1); // as it always was
    seconds.setValue(600);
    window.document().edit(QStringLiteral("change"), {}, [](Scene& scene) { scene.view.exposure = 1.0; });
    QTest::qWait(1500);
    QVERIFY(!QFileInfo::exists(window->recovery().copyPath()));
    seconds.setValue(1); // a change that waits need not wait the old time
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(window->recovery().copyPath()), 5000);
    seconds.setValue(20);
    StudioWindow again;
    QCOMPARE(again->recovery().seconds(), 20);
}

void PreferencesTest::everyControlExplainsItself()
{
    StudioWindow window;
    window.show();
    PreferencesDialog& dialog = openPreferences(window);
    auto& tabs = *dialog.findChild<QTabWidget*>();
    for (int i = 0; i < tabs.count(); ++i) {
        tabs.setCurrentIndex(i);
        keepScreenshot(dialog, QStringLiteral("preferences-%1").arg(i));
    }
    const QStringList silent = unexplained(dialog);
    QVERIFY2(silent.isEmpty(), qPrintable(silent.join(QStringLiteral(", "))));
    QTest::keyClick(&dialog, Qt::Key_F1);
    QVERIFY(window->help().helpWindow());
}

} // namespace mirrorball::test
