#include "help_test.h"

#include "studio_window.h"
#include "widget_driver.h"

#include "app/studio/command_palette.h"
#include "app/studio/docks.h"
#include "app/studio/help/guide.h"
#include "app/studio/help/help_window.h"
#include "app/studio/help/shortcut_list.h"
#include "app/studio/samples.h"
#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "widgets/controls/color_button.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/text.h"
#include "widgets/exports/export_dialog.h"
#include "widgets/spheremap/sphere_map_panel.h"

#include <QComboBox>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QTextBlock>
#include <QToolButton>

#include <algorithm>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<HelpTest> registered;

void HelpTest::init() { QSettings().clear(); }

namespace {

/// The heading that stands highest in the page as it is scrolled.
QString topHeading(HelpWindow& help)
{
    for (QTextBlock block = help.text().cursorForPosition({10, 30}).block(); block.isValid(); block = block.previous())
        if (block.blockFormat().headingLevel() > 0)
            return block.text();
    return {};
}

QAction* command(StudioWindow& window, const char* name) { return window->findChild<QAction*>(QLatin1String(name)); }

} // namespace

// ---- the guide -----------------------------------------------------------------------------------------------------------------

void HelpTest::theWholeGuideIsThere()
{
    QVERIFY(guidePages().size() > 15); // a page a row of the table, and the table
    HelpWindow help;
    for (const GuidePage& page : guidePages()) {
        QVERIFY2(!guideText(page.file).isEmpty(), qPrintable(page.file));
        help.showPage(page.file);
        QCOMPARE(help.page(), page.file);
        QVERIFY2(help.text().document()->blockCount() > 3, qPrintable(page.file));
        for (QTextBlock block = help.text().document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
                if (const QTextImageFormat image = part.fragment().charFormat().toImageFormat(); image.isValid())
                    QVERIFY2(!help.text().document()->resource(QTextDocument::ImageResource, QUrl(image.name())).isNull(),
                             qPrintable(image.name()));
    }
    QVERIFY(unexplained(help).isEmpty());
    help.showPage(QStringLiteral("studio.md"));
    keepScreenshot(help, QStringLiteral("help"));
}

void HelpTest::everyDockOpensAPageByF1()
{
    StudioWindow window;
    window.show();
    QTest::mouseClick(window->findChild<ColorButton*>(QStringLiteral("material.diffuse.color")), Qt::LeftButton); // the picker has work
    for (const DockEntry& entry : dockEntries()) {
        QDockWidget* dock = window->dock(QLatin1String(entry.id));
        dock->show();
        dock->raise();
        QTRY_VERIFY(dock->widget()->isVisible());
        const auto controls = dock->widget()->findChildren<QWidget*>();
        const auto control = std::find_if(controls.begin(), controls.end(), [](const QWidget* w) {
            return w->isVisible() && w->isEnabled() && w->focusPolicy() & Qt::TabFocus;
        });
        QVERIFY2(control != controls.end(), entry.id);
        (*control)->setFocus();
        QTest::keyClick(*control, Qt::Key_F1);
        QVERIFY(window->help().helpWindow());
        QCOMPARE(window->help().helpWindow()->page(), QString::fromLatin1(entry.page));
        window->help().helpWindow()->close();
        QApplication::setActiveWindow(&*window);
    }
    window.preview().setFocus();
    QTest::keyClick(&window.preview(), Qt::Key_F1);
    QCOMPARE(window->help().helpWindow()->page(), QStringLiteral("studio.md"));
}

void HelpTest::aDialogOpensItsPageByF1()
{
    StudioWindow window;
    window.show();
    window->openExport();
    auto* dialog = window->findChild<ExportDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    QApplication::setActiveWindow(dialog);
    QTest::keyClick(dialog, Qt::Key_F1);
    QVERIFY(window->help().helpWindow());
    QCOMPARE(window->help().helpWindow()->page(), QStringLiteral("engines.md"));
    dialog->close();
}

void HelpTest::whatIsThisOpensThePageOfWhatIsClicked()
{
    StudioWindow window;
    window.show();
    const Scene before = window.document().scene();
    QTest::keyClick(&*window, Qt::Key_F1, Qt::ShiftModifier);
    QVERIFY(window->help().isAsking());
    auto* kind = window->findChild<QComboBox*>(QStringLiteral("map.parameterization"));
    QTest::mouseClick(kind, Qt::LeftButton);
    QVERIFY(!window->help().isAsking());
    QCOMPARE(window->help().helpWindow()->page(), QStringLiteral("parameterizations.md"));
    QCOMPARE(window->help().helpWindow()->search().text(), QStringLiteral("Parameterization"));
    QVERIFY(!kind->view()->isVisible()); // the click asked and did nothing else
    QVERIFY(window.document().scene() == before);

    QTest::keyClick(&*window, Qt::Key_F1, Qt::ShiftModifier);
    QTest::keyClick(&window.preview(), Qt::Key_Escape);
    QVERIFY(!window->help().isAsking());
}

void HelpTest::linksAndHistoryLead()
{
    HelpWindow help;
    help.showPage(QStringLiteral("README.md"));
    emit help.text().anchorClicked(QUrl(QStringLiteral("files.md#which-way-round")));
    QCOMPARE(help.page(), QStringLiteral("files.md"));
    QTRY_COMPARE(topHeading(help), QStringLiteral("Which way round"));
    const QList<QToolButton*> buttons = help.findChildren<QToolButton*>();
    const auto back = std::find_if(buttons.begin(), buttons.end(),
                                   [](const QToolButton* button) { return button->shortcut() == QKeySequence(QKeySequence::Back); });
    QVERIFY(back != buttons.end());
    (*back)->click();
    QCOMPARE(help.page(), QStringLiteral("README.md"));
    emit help.text().anchorClicked(QUrl(QStringLiteral("../CONTRIBUTING.md"))); // is not in the guide
    QCOMPARE(help.page(), QStringLiteral("README.md"));
    help.pages().setCurrentRow(1);
    QCOMPARE(help.page(), guidePages()[1].file);
}

void HelpTest::theShortcutsAreThoseOfTheActions()
{
    StudioWindow window;
    window.show();
    QStringList keys;
    for (const Shortcut& shortcut : shortcutsOf(*window)) {
        QVERIFY2(!shortcut.what.isEmpty() && !shortcut.where.isEmpty(), qPrintable(shortcut.keys));
        keys << shortcut.keys.split(QStringLiteral(", "));
    }
    for (const QAction* action : window->findChildren<QAction*>())
        if (!action->shortcut().isEmpty() && action->parent() && !action->parent()->inherits("QLineEdit"))
            QVERIFY2(keys.contains(action->shortcut().toString(QKeySequence::NativeText)), qPrintable(action->text()));
    QTest::keyClick(&*window, Qt::Key_Slash, Qt::ControlModifier);
    QVERIFY(window->help().helpWindow());
    const QString shown = window->help().helpWindow()->text().toPlainText();
    for (const char* text : {"Ctrl+O", "Open", "Undo", "Command palette", "Snapshot"})
        QVERIFY2(shown.contains(QLatin1String(text), Qt::CaseInsensitive), text);
    keepScreenshot(*window->help().helpWindow(), QStringLiteral("shortcuts"));
}

// ---- the tour ------------------------------------------------------------------------------------------------------------------

void HelpTest::theTourDoesARealJob()
{
    const TemporaryFolder folder;
    StudioWindow window;
    window.show();
    Tour& tour = window->tour();
    command(window, "help.tour")->trigger();
    QCOMPARE(tour.step(), 0);
    QCOMPARE(tour.steps(), 5);
    QVERIFY(tour.isVisible());
    window.waitForPicture();
    keepScreenshot(*window, QStringLiteral("tour"));

    auto* probes = window->findChild<QListView*>(QStringLiteral("probes.list"));
    window.document().edit(QStringLiteral("aside"), {}, [](Scene& scene) { scene.view.exposure = 1.0; });
    QCOMPARE(tour.step(), 0); // something else was done
    probes->setFocus();
    QTest::keyClick(probes, Qt::Key_End);
    QTest::keyClick(probes, Qt::Key_Return);
    QCOMPARE(tour.step(), 1);

    const QPoint middle = window.preview().rect().center();
    QTest::mousePress(&window.preview(), Qt::RightButton, Qt::ShiftModifier, middle);
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(60, 0), window.preview().mapToGlobal(middle + QPoint(60, 0)), Qt::NoButton,
                     Qt::RightButton, Qt::ShiftModifier);
    QApplication::sendEvent(&window.preview(), &move);
    QCOMPARE(tour.step(), 1); // the hand has not let go
    QTest::mouseRelease(&window.preview(), Qt::RightButton, Qt::ShiftModifier, middle + QPoint(60, 0));
    QCOMPARE(tour.step(), 2);

    const auto choose = [&](const char* name, int index) {
        auto* combo = window->findChild<QComboBox*>(QLatin1String(name));
        combo->setCurrentIndex(index);
        emit combo->activated(index);
    };
    choose("materialPresets", 2);
    QCOMPARE(tour.step(), 3);
    choose("map.parameterization", 4);
    QCOMPARE(tour.step(), 4);

    window->openExport();
    auto* dialog = window->findChild<ExportDialog*>();
    QVERIFY(dialog);
    dialog->setFolder(fromPath(folder.path()));
    dialog->list().add(ExportKind::Specular);
    dialog->startExport();
    QTRY_VERIFY_WITH_TIMEOUT(!tour.isRunning(), 60000);
    QVERIFY(!tour.isVisible());
    QVERIFY(!std::filesystem::is_empty(folder.path()));
    dialog->close();
}

void HelpTest::theTourIsOfferedOnce()
{
    {
        StudioWindow window;
        QVERIFY(!window->tour().isRunning());
        window->greet(); // as main() does where no file is opened
        QVERIFY(window->tour().isRunning());
        QTest::mouseClick(window->findChild<QPushButton*>(QStringLiteral("tour.end")), Qt::LeftButton);
        QVERIFY(!window->tour().isRunning());
    }
    StudioWindow again;
    again->greet();
    QVERIFY(!again->tour().isRunning());
    command(again, "help.tour")->trigger();
    QVERIFY(again->tour().isRunning());
}

void HelpTest::aStepCanBeShownOrSkipped()
{
    StudioWindow window;
    window.show();
    window->tour().start();
    auto* skip = window->findChild<QPushButton*>(QStringLiteral("tour.skip"));
    auto* show = window->findChild<QPushButton*>(QStringLiteral("tour.show"));
    QTest::mouseClick(skip, Qt::LeftButton);
    QTest::mouseClick(show, Qt::LeftButton); // the light's turn, in a dock behind a tab
    QTRY_VERIFY(window->dock(QStringLiteral("view"))->widget()->isVisible());
    QWidget* focus = QApplication::focusWidget();
    QVERIFY(focus);
    const auto* turn = window->dock(QStringLiteral("view"))->findChild<QWidget*>(QStringLiteral("probe.yaw"));
    QVERIFY(turn->isAncestorOf(focus));
    for (int step = 2; step < window->tour().steps(); ++step)
        QTest::mouseClick(skip, Qt::LeftButton);
    QCOMPARE(window->tour().step(), window->tour().steps() - 1);
    QTest::mouseClick(skip, Qt::LeftButton);
    QVERIFY(!window->tour().isRunning());
}

// ---- samples and the palette ---------------------------------------------------------------------------------------------------

void HelpTest::samplesOpenWithoutAFile()
{
    StudioWindow window;
    window.show();
    auto* menu = window->findChild<QMenu*>(QStringLiteral("file.samples"));
    QVERIFY(menu);
    QCOMPARE(menu->actions().size(), samples().size());
    QVERIFY(menu->actions().size() >= 7);
    for (QAction* action : menu->actions()) {
        window.document().reset();
        action->trigger();
        QVERIFY2(window.document().filePath().isEmpty(), qPrintable(action->text()));
        QVERIFY2(!(window.document().scene() == newScene()), qPrintable(action->text()));
        window.waitForPicture();
        QVERIFY2(window->workspace().notices.all().isEmpty(), qPrintable(action->text()));
        keepScreenshot(*window, QStringLiteral("sample-") + action->text().section(QStringLiteral("  "), 0, 0));
    }
}

void HelpTest::thePaletteFindsControls()
{
    StudioWindow window;
    window.show();
    const auto run = [&](const QString& typed) {
        QApplication::setActiveWindow(&*window);
        QTest::keyClick(&*window, Qt::Key_P, Qt::ControlModifier);
        auto* palette = window->findChild<CommandPalette*>();
        QVERIFY(palette);
        QTest::keyClicks(&palette->input(), typed);
        keepScreenshot(*palette, QStringLiteral("palette-") + typed);
        QTest::keyClick(&palette->input(), Qt::Key_Return);
        QTRY_VERIFY(!window->findChild<CommandPalette*>());
    };
    const auto hasKeys = [&](const char* dock, const char* control) {
        const auto* wanted = window->dock(QLatin1String(dock))->findChild<QWidget*>(QLatin1String(control));
        const QWidget* focus = QApplication::focusWidget();
        return wanted && focus && (wanted == focus || wanted->isAncestorOf(focus));
    };
    run(QStringLiteral("view: field of view")); // behind a tab
    QVERIFY(window->dock(QStringLiteral("view"))->widget()->isVisible());
    QVERIFY(hasKeys("view", "view.camera.fov"));
    run(QStringLiteral("parameterization"));
    QVERIFY(hasKeys("map", "map.parameterization"));
    window->dock(QStringLiteral("map"))->hide(); // closed
    run(QStringLiteral("map: parameterization"));
    QVERIFY(window->dock(QStringLiteral("map"))->isVisible());
    window->workspace().sphereMap.setMap(QStringLiteral("map"), SphereMapDocument{.layers = {Layer{.content = PaintLayer{}}}});
    run(QStringLiteral("sphere map: hardness")); // on a tab inside a dock behind a tab
    QTRY_VERIFY(hasKeys("sphere-map", "brushForm"));
}

} // namespace mirrorball::test
