#include "context_menu_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "widgets/controls/color_button.h"
#include "widgets/controls/text.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QListView>
#include <QMenu>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<ContextMenuTest> registered;

void ContextMenuTest::init()
{
    QSettings().clear();
    QApplication::clipboard()->clear();
}

namespace {

/// The menu of that name, after a right click.
QMenu* menuAt(QWidget& widget, const QPoint& at, const char* name)
{
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, widget.mapToGlobal(at));
    QApplication::sendEvent(&widget, &event);
    QMenu* found = nullptr;
    for (QWidget* top : QApplication::topLevelWidgets())
        if (top->objectName() == QLatin1String(name) && top->isVisible())
            found = qobject_cast<QMenu*>(top);
    return found;
}

QAction* item(const QMenu& menu, const QString& text)
{
    for (QAction* action : menu.actions())
        if (action->text().remove(u'&').startsWith(text))
            return action;
    return nullptr;
}

/// Runs an item as a click does, and closes the menu.
void run(QMenu* menu, const char* text)
{
    QVERIFY(menu);
    QAction* action = item(*menu, QLatin1String(text));
    QVERIFY2(action && action->isEnabled(), text);
    action->trigger();
    menu->close();
}

} // namespace

void ContextMenuTest::thePictureHasAMenu()
{
    StudioWindow window;
    window.show();
    window.document().edit(QStringLiteral("exposure"), {}, [](Scene& scene) { scene.view.exposure = 2.0; });
    QMenu* menu = menuAt(window.preview(), window.preview().rect().center(), "pictureMenu");
    QVERIFY(menu);
    keepScreenshot(*menu, QStringLiteral("picture-menu"));
    run(menu, "Reset exposure");
    QCOMPARE(window.document().scene().view.exposure, 0.0);
    run(menuAt(window.preview(), window.preview().rect().center(), "pictureMenu"), "Copy");
    QCOMPARE(QApplication::clipboard()->image().size(), window.preview().picture().size());
}

void ContextMenuTest::theMenuStaysAwayFromDragsOfTheRightButton()
{
    Painting painting;
    StudioWindow& window = painting.window();
    painting.editor().setPaintsOnModel(true); // where a right drag changes the brush
    QVERIFY(!menuAt(window.preview(), window.preview().rect().center(), "pictureMenu"));
}

void ContextMenuTest::aProbeOfTheListHasAMenu()
{
    const TemporaryFolder folder;
    const QString file = fromPath(folder / "room.hdr");
    writeImage(folder / "room.hdr", renderBuiltinProbe("cube-room", {Parameterization::Latlong, 32, 0}).image);
    StudioWindow window;
    window.show();
    ProbeLibrary& library = window->workspace().library;
    library.addFile(file);
    auto* list = window->findChild<QListView*>(QStringLiteral("probes.list"));
    const auto at = [&] {
        for (int row = 0; row < list->model()->rowCount(); ++row)
            if (list->model()->index(row, 0).data(ProbeLibrary::SourceRole).toString() == file) {
                list->scrollTo(list->model()->index(row, 0));
                return list->visualRect(list->model()->index(row, 0)).center();
            }
        return QPoint();
    };
    run(menuAt(*list->viewport(), at(), "probeMenu"), "Copy its path");
    QCOMPARE(QApplication::clipboard()->text(), file);
    run(menuAt(*list->viewport(), at(), "probeMenu"), "Light the scene with it");
    QCOMPARE(QString::fromStdString(window.document().scene().probe.source), file);
    window.document().undoStack().undo();
    QVERIFY(QFile::remove(file)); // the card of a file that is gone can go, too
    run(menuAt(*list->viewport(), at(), "probeMenu"), "Remove from the list");
    QCOMPARE(library.rowOf(file), -1);
}

void ContextMenuTest::aLayerHasAMenu()
{
    Painting painting;
    LayerList& list = painting.panel().layers().list();
    const auto menu = [&](int row) { return menuAt(*list.viewport(), list.visualRect(list.model()->index(row, 0)).center(), "layerMenu"); };
    run(menu(1), "Hide"); // the ground
    QVERIFY(!painting.editor().map()->layers[0].visible);
    QCOMPARE(painting.editor().chosen(), 0);
    run(menu(1), "Show");
    QVERIFY(painting.editor().map()->layers[0].visible);
    run(menu(1), "Copy");
    run(menu(0), "Paste above");
    QCOMPARE(painting.editor().map()->layers.size(), size_t(3));
    QVERIFY(painting.editor().map()->layers[2] == painting.editor().map()->layers[0]);
    run(menu(0), "Move down");
    QVERIFY(painting.editor().map()->layers[1] == painting.editor().map()->layers[0]);
    QMenu* top = menu(0);
    QVERIFY(top && !item(*top, QStringLiteral("Move up"))->isEnabled());
    keepScreenshot(*top, QStringLiteral("layer-menu"));
    run(top, "Delete");
    QCOMPARE(painting.editor().map()->layers.size(), size_t(2));
}

void ContextMenuTest::aMapHasAMenu()
{
    StudioWindow window;
    window.show();
    auto* view = window->findChild<QWidget*>(QStringLiteral("map.view"));
    auto* grid = window->findChild<QAbstractButton*>(QStringLiteral("map.grid"));
    run(menuAt(*view, view->rect().center(), "mapMenu"), "Grid");
    QVERIFY(grid->isChecked());
    run(menuAt(*view, view->rect().center(), "mapMenu"), "Copy the view as a picture");
    QVERIFY(!QApplication::clipboard()->image().isNull());
}

void ContextMenuTest::aSwatchHasAMenu()
{
    StudioWindow window;
    window.show();
    auto* swatch = window->findChild<ColorButton*>(QStringLiteral("material.diffuse.color"));
    QVERIFY(swatch);
    QApplication::clipboard()->setText(QStringLiteral("#ff8000"));
    run(menuAt(*swatch, swatch->rect().center(), "swatchMenu"), "Paste #ff8000");
    const glm::dvec3 color = window.document().scene().material.diffuse.color;
    QCOMPARE(color.r, 1.0);
    QVERIFY(std::abs(color.g - 0.21586) < 2e-5); // sRGB 128 of 255, IEC 61966-2-1
    QCOMPARE(color.b, 0.0);
    QApplication::clipboard()->setText(QStringLiteral("no color"));
    QMenu* menu = menuAt(*swatch, swatch->rect().center(), "swatchMenu");
    QVERIFY(menu && !item(*menu, QStringLiteral("Paste"))->isEnabled());
    run(menu, "Copy #ff8000");
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("#ff8000"));
}

} // namespace mirrorball::test
