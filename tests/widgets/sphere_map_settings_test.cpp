#include "sphere_map_settings_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "widgets/controls/text.h"
#include "widgets/panels/preset_gallery.h"
#include "widgets/panels/view_panel.h"
#include "widgets/spheremap/sphere_map_source_field.h"

#include "core/base/field_checks.h"
#include "core/image/image_io.h"
#include "core/scene/live_maps.h"
#include "core/spheremap/document/sphere_map_file.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QTimer>

#include <map>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<SphereMapSettingsTest> registered;

namespace {

template <typename T>
T* named(QWidget& root, const char* name)
{
    return root.findChild<T*>(QLatin1String(name));
}

QAction* actionNamed(QWidget& window, const QString& name) { return window.findChild<QAction*>(name); }

void addByMenu(Painting& painting, const QString& title)
{
    auto* add = named<QToolButton>(painting.panel(), "addLayer");
    for (QAction* action : add->menu()->actions())
        if (action->text() == title)
            return action->trigger();
    QFAIL(qPrintable(title));
}

/// Answers the next file dialog: with a file, or without.
void answerFileDialog(const QString& path)
{
    QTimer::singleShot(0, qApp, [path] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!dialog)
            return;
        if (path.isEmpty()) {
            dialog->reject();
            return;
        }
        dialog->setDirectory(QFileInfo(path).path());
        dialog->selectFile(path);
        QMetaObject::invokeMethod(dialog, "accept");
    });
}

/// The paths of all that a file can set.
struct Paths {
    QStringList found{};
    QString path{};

    template <typename T>
    void operator()(const Field& field, const T& value)
    {
        const QString here = path.isEmpty() ? toQString(field.name) : path + u'.' + toQString(field.name);
        if constexpr (hasFields<T>) {
            Paths inner{.path = here};
            T::visitFields(value, inner);
            found += inner.found;
        } else {
            found << here;
        }
    }
};

} // namespace

void SphereMapSettingsTest::init() { QSettings().clear(); }

void SphereMapSettingsTest::everyFieldOfASceneFileHasAControl()
{
    const std::map<QString, QString> elsewhere{
        {QStringLiteral("probe.source"), QStringLiteral("probes.list")},
        {QStringLiteral("probe.parameterization"), QStringLiteral("probes.read_as")},
        {QStringLiteral("material.sphere_map.document"), QStringLiteral("sphereMapTabs")},
        {QStringLiteral("view.display.config"), QStringLiteral("view.display")},
        {QStringLiteral("view.display.display"), QStringLiteral("view.display")},
        {QStringLiteral("view.display.view"), QStringLiteral("view.display")},
        {QStringLiteral("exports"), QStringLiteral("file.export")},
    };
    StudioWindow window;
    Paths paths;
    const Scene scene;
    Scene::visitFields(scene, paths);
    QVERIFY(paths.found.size() > 60);
    QStringList wanting;
    for (const QString& path : paths.found) {
        const auto other = elsewhere.find(path);
        if (!window->findChild<QObject*>(other == elsewhere.end() ? path : other->second))
            wanting << path;
    }
    QVERIFY2(wanting.isEmpty(), qPrintable(wanting.join(u'\n')));
}

void SphereMapSettingsTest::useOpacityAndColorAreAtHandAndUndoneStepByStep()
{
    Painting painting;
    const auto map = [&]() -> const SphereMapSettings& { return painting.document().scene().material.sphereMap; };
    auto* color = named<ColorButton>(painting.panel(), "material.sphere_map.color");
    const int before = painting.steps();
    QVERIFY(color->isVisible());
    pick(painting.panel(), "material.sphere_map.use", static_cast<int>(SphereMapUse::Over));
    QVERIFY(map().use == SphereMapUse::Over);
    QVERIFY(!color->isVisible()); // the reflecting material lies below
    pick(painting.panel(), "material.sphere_map.use", static_cast<int>(SphereMapUse::Multiply));
    QVERIFY(color->isVisible());
    auto* opacity = named<NumberField>(painting.panel(), "material.sphere_map.opacity");
    for (const double value : {0.8, 0.6, 0.5})
        emit opacity->edited(value);
    emit opacity->finished();
    emit color->edited({0.1, 0.2, 0.3});
    emit color->finished();
    QCOMPARE(painting.steps(), before + 4);
    QCOMPARE(map().opacity, 0.5);
    QVERIFY(map().color == glm::dvec3(0.1, 0.2, 0.3));
    for (int i = 0; i < 4; ++i)
        painting.document().undoStack().undo();
    QVERIFY(map().use == SphereMapUse::Replace);
    QCOMPARE(opacity->value(), 1.0);
}

void SphereMapSettingsTest::theRestOfTheMapIsSetInItsTab()
{
    Painting painting;
    painting.panel().tabs().setCurrentIndex(3);
    OptionsForm& form = painting.panel().mapForm().form();
    const auto map = [&]() -> const SphereMapSettings& { return painting.document().scene().material.sphereMap; };
    auto* size = named<QComboBox>(form, "material.sphere_map.size");
    QStringList sizes;
    for (int i = 0; i < size->count(); ++i)
        sizes << QString::number(size->itemData(i).toInt());
    QCOMPARE(sizes.join(u' '), QStringLiteral("128 256 512 1024 2048 4096"));
    pick(form, "material.sphere_map.size", size->findData(2048));
    QCOMPARE(map().size, 2048);
    QCOMPARE(painting.editor().size(), 2048);
    pick(form, "material.sphere_map.space", static_cast<int>(MapSpace::World));
    QVERIFY(map().space == MapSpace::World);
    pick(form, "material.sphere_map.levels", static_cast<int>(SphereMapLevels::Plain));
    QVERIFY(map().levels == SphereMapLevels::Plain);
    pick(form, "material.sphere_map.lookup", static_cast<int>(LookupAt::Vertex));
    QVERIFY(map().lookup == LookupAt::Vertex);
    auto* density = named<NumberField>(form, "material.sphere_map.flecks.density");
    emit density->edited(0.4);
    emit density->finished();
    QCOMPARE(map().flecks.cells.density, 0.4);
    named<QSpinBox>(form, "material.sphere_map.flecks.seed")->setValue(7);
    QCOMPARE(map().flecks.cells.seed, 7);
    pick(form, "material.sphere_map.document.index", static_cast<int>(SphereMapIndex::Reflection));
    QVERIFY(painting.editor().map()->index == SphereMapIndex::Reflection);
    auto* title = named<QLineEdit>(form, "material.sphere_map.document.title");
    title->setText(QStringLiteral("Old bronze"));
    emit title->editingFinished();
    QCOMPARE(painting.editor().map()->title, std::string("Old bronze"));
    painting.document().undoStack().undo();
    QVERIFY(painting.editor().map()->title != "Old bronze");
    QCOMPARE(title->text(), toQString(painting.editor().map()->title));
    painting.waitForPicture();
    QVERIFY(unexplained(form).isEmpty());
}

void SphereMapSettingsTest::aDoubleClickOnALabelResetsTheField()
{
    Painting painting;
    OptionsForm& form = painting.panel().mapForm().form();
    painting.panel().tabs().setCurrentIndex(3);
    pick(form, "material.sphere_map.space", static_cast<int>(MapSpace::World));
    QWidget* label = form.layout()->labelForField(form.control(QStringLiteral("material.sphere_map.space")));
    QTest::mouseDClick(label, Qt::LeftButton);
    QVERIFY(painting.document().scene().material.sphereMap.space == MapSpace::Eye);
    painting.panel().tabs().setCurrentIndex(0);
    painting.editor().addLayer(makeLayer("toon"));
    auto* count = painting.panel().layers().form().findChild<QSpinBox*>(QStringLiteral("count"));
    count->setValue(7);
    auto* layout = painting.panel().layers().form().findChild<QFormLayout*>();
    QTest::mouseDClick(layout->labelForField(count), Qt::LeftButton);
    QCOMPARE(std::get<ToonLayer>(painting.editor().chosenLayer()->content).count, ToonLayer{}.count);
}

void SphereMapSettingsTest::coordinatesAreInterpolatedAtVerticesByAMenuCommand()
{
    StudioWindow window;
    window.show();
    QAction* lookup = actionNamed(*window, QStringLiteral("view.lookup"));
    QVERIFY(lookup && lookup->isCheckable() && !lookup->isChecked());
    lookup->trigger();
    QVERIFY(window.document().scene().material.sphereMap.lookup == LookupAt::Vertex);
    QVERIFY(lookup->isChecked());
    window.document().undoStack().undo();
    QVERIFY(!lookup->isChecked());
}

// In the room, before the pane: the wall with the window stands at z = 0, the room lies towards +Z.
void SphereMapSettingsTest::theWindowIsSeenFromTheRoom()
{
    StudioWindow window;
    window.show();
    const Scene before = window.document().scene();
    auto* bodies = named<QComboBox>(*window, "view.geometry");
    pick(*window, "view.geometry", bodies->findData(QStringLiteral("window")));
    QCOMPARE(window.document().undoStack().count(), 1);
    const auto camera = [&]() -> const CameraSettings& { return window.document().scene().view.camera; };
    QCOMPARE(window.document().scene().view.geometry, std::string("window"));
    const CameraSettings inside = camera();
    QVERIFY(std::abs(inside.yawDeg) < 45.0 && std::abs(inside.pitchDeg) < 15.0 && inside.distance > 1.0 && inside.distance < 4.5);
    QVERIFY(!window.document().scene().material.sphereMap.isNone()); // there is something outside
    window.waitForPicture();
    QVERIFY(window->workspace().notices.all().isEmpty());
    const QImage picture = window.picture();
    QVERIFY(picture.pixelColor(picture.width() / 2 + picture.height() / 12, picture.height() / 3).lightness() > 150); // a pane
    QVERIFY(picture.pixelColor(3, 3).lightness() < 100);                                                              // the room's wall

    QWheelEvent away({5, 5}, window.preview().mapToGlobal(QPointF(5, 5)), {}, {0, -1200}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                     false);
    QCoreApplication::sendEvent(&window.preview(), &away);
    Painting::drag(&window.preview(), {300, 200}, {100, 250});
    QVERIFY(camera() != inside);
    QTest::keyClick(&window.preview(), Qt::Key_F);
    QVERIFY(camera() == inside);

    pick(*window, "view.geometry", bodies->findData(QStringLiteral("teapot")));
    QVERIFY(camera() == CameraSettings{});
    QVERIFY(window.document().scene().material.sphereMap.isNone()); // a meadow is no material for a teapot
    while (window.document().undoStack().canUndo())
        window.document().undoStack().undo();
    QVERIFY(window.document().scene() == before);
}

void SphereMapSettingsTest::theWindowsLayersAreChosenByNameOrFile()
{
    StudioWindow window;
    window.document().edit(QStringLiteral("window"), {}, [](Scene& scene) { useGeometry(scene, "window"); });
    window.show();
    window->dock(QStringLiteral("view"))->raise();
    const auto view = [&]() -> const WindowSettings& { return window.document().scene().view.window; };
    auto* middle = named<SphereMapSourceField>(*window, "view.window.middle");
    QTRY_VERIFY(middle->isVisible());
    QCOMPARE(middle->text().text(), toQString(view().middle));
    middle->text().setText(QStringLiteral("sky"));
    emit middle->text().editingFinished();
    QCOMPARE(view().middle, std::string("sky"));
    auto* depth = named<NumberField>(*window, "view.window.middle_depth");
    QVERIFY(depth->isVisible());
    emit depth->edited(30.0);
    emit depth->finished();
    QCOMPARE(view().middleDepth, 30.0);
    middle->text().clear();
    emit middle->text().editingFinished();
    QVERIFY(view().middle.empty());
    QVERIFY(!depth->isVisible());
    const TemporaryFolder folder;
    saveSphereMap(findSphereMapPreset("hills")->document, folder / "own.spheremap");
    answerFileDialog(fromPath(folder / "own.spheremap"));
    middle->text().findChild<QAction*>(QStringLiteral("chooseFile"))->trigger();
    QCOMPARE(view().middle, (folder / "own.spheremap").string());
    window.waitForPicture();
    QVERIFY(window->workspace().notices.all().isEmpty());
}

void SphereMapSettingsTest::aPresetIsFoundByTypingAndTakenByEnter()
{
    Painting painting(false);
    auto* gallery = painting.panel().findChild<PresetGallery*>();
    QVERIFY(gallery && gallery->isVisible());
    QCOMPARE(gallery->list().model()->rowCount(), painting.window()->workspace().presets.rowCount());
    QTest::keyClicks(&gallery->find(), QStringLiteral("porcel"));
    QCOMPARE(gallery->list().model()->rowCount(), 1);
    QTest::keyClick(&gallery->find(), Qt::Key_Return);
    QVERIFY(painting.editor().map());
    QCOMPARE(painting.editor().map()->title, findSphereMapPreset("porcelain")->title);
    painting.document().undoStack().undo();

    PresetGallery* popup = openPresetGallery(painting.window()->workspace().presets, painting.panel(), QStringLiteral("jade"));
    QPointer<PresetGallery> guard(popup);
    QString chosen;
    connect(popup, &PresetGallery::chosen, this, [&chosen](const QString& name) { chosen = name; });
    QCOMPARE(popup->list().currentIndex().data(PresetLibrary::NameRole).toString(), QStringLiteral("jade"));
    QTest::keyClick(&popup->find(), Qt::Key_Down); // the row below
    const QString below = popup->list().currentIndex().data(PresetLibrary::NameRole).toString();
    QVERIFY(!below.isEmpty() && below != QStringLiteral("jade"));
    QTest::keyClick(&popup->find(), Qt::Key_Return);
    QCOMPARE(chosen, below);
    QTRY_VERIFY(!guard);
}

void SphereMapSettingsTest::presetsHavePicturesOfTheirBalls()
{
    PresetLibrary library;
    const QModelIndex jade = library.index(library.rowOf(QStringLiteral("jade")));
    QVERIFY(jade.data(Qt::DecorationRole).isNull()); // this asks for it
    QTRY_VERIFY_WITH_TIMEOUT(!jade.data(Qt::DecorationRole).isNull(), 20000);
    const QImage ball = jade.data(Qt::DecorationRole).value<QImage>();
    QCOMPARE(ball.deviceIndependentSize().toSize(), QSize(PresetLibrary::pictureEdge, PresetLibrary::pictureEdge));
    QCOMPARE(ball.devicePixelRatio(), 2.0);
    QCOMPARE(ball.pixelColor(0, 0).alpha(), 0);
    QCOMPARE(ball.pixelColor(ball.width() / 2, ball.height() / 2).alpha(), 255);
    QVERIFY(ball.pixelColor(ball.width() / 2, ball.height() / 2).green() > ball.pixelColor(ball.width() / 2, ball.height() / 2).red());
}

void SphereMapSettingsTest::aLinkedMapStaysInItsFileUntilItIsCopied()
{
    const TemporaryFolder folder;
    saveSphereMap(findSphereMapPreset("jade")->document, folder / "stone.spheremap");
    Painting painting(false);
    painting.panel().linkMap(fromPath(folder / "stone.spheremap"));
    QVERIFY(!painting.editor().map());
    auto* source = named<SphereMapSourceField>(painting.panel(), "material.sphere_map.source");
    QVERIFY(source->isVisible());
    QVERIFY(named<QWidget>(painting.panel(), "material.sphere_map.use")->isVisible());
    QVERIFY(!painting.canvas().isVisible());
    QTest::mouseClick(named<QWidget>(painting.panel(), "ownSphereMap"), Qt::LeftButton);
    QVERIFY(painting.editor().map());
    QCOMPARE(painting.editor().map()->layers, findSphereMapPreset("jade")->document.layers);
    QVERIFY(painting.document().scene().material.sphereMap.source.empty());
    QVERIFY(painting.canvas().isVisible() && !source->isVisible());
    painting.document().undoStack().undo();
    QVERIFY(!painting.editor().map() && source->isVisible());
    QTest::mouseClick(named<QWidget>(painting.panel(), "unlinkSphereMap"), Qt::LeftButton);
    QVERIFY(painting.document().scene().material.sphereMap.isNone());
}

void SphereMapSettingsTest::newLayersAreBlendedAsTheirKindIs()
{
    Painting painting;
    addByMenu(painting, QStringLiteral("Phong lights"));
    QVERIFY(painting.editor().chosenLayer()->blend == BlendMode::Add);
    addByMenu(painting, QStringLiteral("Colorgram"));
    QVERIFY(painting.editor().chosenLayer()->blend == BlendMode::Multiply);
    addByMenu(painting, QStringLiteral("Silhouette ring"));
    QVERIFY(painting.editor().chosenLayer()->blend == BlendMode::Normal);
}

void SphereMapSettingsTest::anImageLayerIsAddedWithItsFile()
{
    const TemporaryFolder folder;
    writeImage(folder / "ball.png", Image(8, 8, 3, 0.5f), {.encoding = Encoding::Display});
    Painting painting;
    const int before = painting.steps();
    answerFileDialog({});
    addByMenu(painting, QStringLiteral("Image"));
    QCOMPARE(painting.steps(), before);
    QCOMPARE(painting.editor().map()->layers.size(), size_t{2});
    answerFileDialog(fromPath(folder / "ball.png"));
    addByMenu(painting, QStringLiteral("Image"));
    QCOMPARE(painting.steps(), before + 1);
    QCOMPARE(std::get<ImageLayer>(painting.editor().chosenLayer()->content).source, (folder / "ball.png").string());
    QCOMPARE(painting.editor().chosenLayer()->name, std::string("ball"));
    painting.waitForPicture();
    QVERIFY(painting.window()->workspace().notices.all().isEmpty());
}

/// For people to look at: MIRRORBALL_SCREENSHOTS.
void SphereMapSettingsTest::looksWell()
{
    if (qEnvironmentVariable("MIRRORBALL_SCREENSHOTS").isEmpty())
        QSKIP("MIRRORBALL_SCREENSHOTS names no folder");
    Painting painting(false);
    StudioWindow& window = painting.window();
    QDockWidget* dock = window->dock(QStringLiteral("sphere-map"));
    dock->setFloating(false);
    dock->raise();
    const auto settle = [&] {
        window.waitForPicture();
        painting.waitForPicture();
        QTRY_VERIFY_WITH_TIMEOUT(!window->workspace().presets.isBusy(), 30000);
        QTest::qWait(150);
    };
    for (const QSize& size : {QSize(1280, 800), QSize(1440, 900)}) {
        const QString name = QStringLiteral("settings-%1").arg(size.width());
        window.document().reset();
        window->resize(size);
        settle();
        keepScreenshot(*window, name + QStringLiteral("-start"));
        PresetGallery* popup = openPresetGallery(window->workspace().presets, painting.panel(), QStringLiteral("jade"));
        settle();
        keepScreenshot(*popup->parentWidget(), name + QStringLiteral("-presets"));
        popup->parentWidget()->close();
        painting.panel().linkMap(QStringLiteral("pearl"));
        settle();
        keepScreenshot(*window, name + QStringLiteral("-linked"));
        painting.editor().setMap({}, findSphereMapPreset("toon-hero")->document);
        painting.panel().tabs().setCurrentIndex(0);
        settle();
        keepScreenshot(*window, name + QStringLiteral("-layers"));
        painting.panel().tabs().setCurrentIndex(3);
        window.document().edit({}, {}, [](Scene& scene) { scene.material.sphereMap.flecks.cells.density = 0.4; });
        settle();
        keepScreenshot(*window, name + QStringLiteral("-map"));
        painting.panel().tabs().setCurrentIndex(2);
        QTRY_VERIFY_WITH_TIMEOUT(!painting.panel().levels().levels().isEmpty(), 20000);
        settle();
        keepScreenshot(*window, name + QStringLiteral("-levels"));
        painting.panel().tabs().setCurrentIndex(0);
        painting.editor().addLayer({.content = ProbeLayer{.fresnel = FresnelKind::Conductor}});
        settle();
        keepScreenshot(*window, name + QStringLiteral("-probe-layer"));
        window.document().reset();
        window.document().edit({}, {}, [](Scene& scene) { useGeometry(scene, "window"); });
        window->dock(QStringLiteral("view"))->raise();
        settle();
        keepScreenshot(*window, name + QStringLiteral("-window"));
        window->dock(QStringLiteral("material"))->raise();
        settle();
        keepScreenshot(*window, name + QStringLiteral("-material"));
        dock->raise();
    }
}

} // namespace mirrorball::test
