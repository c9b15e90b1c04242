#include "layers_page_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "core/spheremap/evaluation/evaluate.h"

#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QScrollBar>
#include <QSettings>
#include <QTimer>

#include <cmath>
#include <memory>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<LayersPageTest> registered;

namespace {

bool isShown(Painting& painting, const char* field)
{
    const QWidget* control = painting.panel().layers().form().control(QLatin1String(field));
    return control && control->isVisibleTo(&painting.panel().layers().form());
}

} // namespace

void LayersPageTest::init() { QSettings().clear(); }

void LayersPageTest::hidesRenamesReordersAndDeletesLayers()
{
    Painting painting;
    LayerList& list = painting.panel().layers().list();
    QAbstractItemModel* model = list.model();
    QCOMPARE(model->rowCount(), 2);
    QCOMPARE(model->index(0, 0).data().toString(), QStringLiteral("Paint")); // the top one first
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(model->index(1, 0)).topLeft() + QPoint(12, 18));
    QVERIFY(!painting.editor().map()->layers[0].visible);
    painting.document().undoStack().undo();
    QVERIFY(painting.editor().map()->layers[0].visible);
    model->setData(model->index(0, 0), QStringLiteral("Shine"), Qt::EditRole);
    QCOMPARE(painting.editor().map()->layers[1].name, std::string("Shine"));
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Down, Qt::ControlModifier);
    QCOMPARE(painting.editor().map()->layers[0].name, std::string("Shine"));
    QCOMPARE(painting.editor().chosen(), 0);
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(painting.editor().map()->layers.size(), size_t{1});
    for (int i = 0; i < 3; ++i)
        painting.document().undoStack().undo();
    QCOMPARE(painting.editor().map()->layers.size(), size_t{2});
    QCOMPARE(painting.editor().map()->layers[1].name, std::string("Paint"));
}

void LayersPageTest::reordersLayersByDropping()
{
    Painting painting;
    painting.editor().addLayer({.name = "Ring", .content = SilhouetteLayer{}});
    QAbstractItemModel* model = painting.panel().layers().list().model(); // rows: Ring, Paint, Ground
    const std::unique_ptr<QMimeData> ring(model->mimeData({model->index(0, 0)}));
    model->dropMimeData(ring.get(), Qt::MoveAction, 3, 0, {}); // below the last
    QCOMPARE(painting.editor().map()->layers[0].name, std::string("Ring"));
    const std::unique_ptr<QMimeData> again(model->mimeData({model->index(2, 0)}));
    model->dropMimeData(again.get(), Qt::MoveAction, 1, 0, {}); // between Paint and Ground
    QCOMPARE(painting.editor().map()->layers[1].name, std::string("Ring"));
    QCOMPARE(painting.editor().map()->layers.size(), size_t{3});
}

void LayersPageTest::editsParametersOneUndoStepADrag()
{
    Painting painting;
    painting.editor().addLayer({.name = "Ring", .content = SilhouetteLayer{}});
    auto* width = painting.panel().layers().form().findChild<NumberField*>(QStringLiteral("width"));
    QVERIFY(width);
    const int before = painting.steps();
    for (const double value : {0.2, 0.25, 0.3})
        emit width->edited(value);
    emit width->finished();
    QCOMPARE(painting.steps(), before + 1);
    QCOMPARE(std::get<SilhouetteLayer>(painting.editor().map()->layers[2].content).width, 0.3);
    auto* opacity = painting.panel().findChild<NumberField*>(QStringLiteral("layerOpacity"));
    emit opacity->edited(0.5);
    emit opacity->finished();
    QCOMPARE(painting.editor().map()->layers[2].opacity, 0.5);
    painting.document().undoStack().undo();
    painting.document().undoStack().undo();
    QCOMPARE(painting.editor().map()->layers[2].opacity, 1.0);
    QCOMPARE(std::get<SilhouetteLayer>(painting.editor().map()->layers[2].content).width, SilhouetteLayer{}.width);
    QCOMPARE(width->value(), SilhouetteLayer{}.width);
}

void LayersPageTest::editsGradientStops()
{
    Painting painting;
    painting.editor().choose(0);
    auto* editor = painting.panel().layers().form().findChild<GradientEditor*>();
    QVERIFY(editor);
    GradientBar& bar = editor->bar();
    QTRY_COMPARE(bar.height(), bar.sizeHint().height()); // a layout places what is new in it when events are next handled
    QVERIFY(bar.isVisible());
    const auto stops = [&] { return std::get<GradientLayer>(painting.editor().map()->layers[0].content).stops; };
    const int before = painting.steps();
    const auto place = [&](double position, int y) { return QPoint(static_cast<int>(std::lround(bar.placeOf(position))), y); };
    const double pixel = 1.0 / (bar.placeOf(1.0) - bar.placeOf(0.0));
    QTest::mouseDClick(&bar, Qt::LeftButton, {}, place(0.5, 12));
    QCOMPARE(stops().size(), size_t{3});
    QVERIFY(std::abs(stops()[2].position - 0.5) < pixel);
    Painting::drag(&bar, place(0.5, 32), place(0.25, 32));
    QVERIFY2(std::abs(stops()[2].position - 0.25) < pixel, qPrintable(QString::number(stops()[2].position)));
    QTest::keyClick(&bar, Qt::Key_Delete);
    QCOMPARE(stops().size(), size_t{2});
    QCOMPARE(painting.steps(), before + 3);
}

void LayersPageTest::masksALayerByPaintingOnItsMask()
{
    Painting painting;
    painting.editor().addLayer({.name = "Cold", .content = FillLayer{.color = {0.1, 0.3, 1.0}}});
    MaskEditor& mask = painting.panel().layers().mask();
    mask.kinds().setCurrentIndex(mask.kinds().findText(QStringLiteral("Paint")));
    emit mask.kinds().activated(mask.kinds().currentIndex());
    const auto layer = [&]() -> const Layer& { return painting.editor().map()->layers[2]; };
    QVERIFY(layer().mask && layer().mask->channel == MaskChannel::Opacity);
    const int before = painting.steps();
    painting.drag(painting.at(-0.3, 0.0), painting.at(0.3, 0.0));
    QCOMPARE(painting.steps(), before + 1);
    QCOMPARE(std::get<PaintLayer>(layer().mask->content).strokes.size(), size_t{1});
    painting.waitForPicture();
    QVERIFY(painting.editor().picture() == evaluate(*painting.editor().map(), {.size = painting.editor().size()}));
    painting.document().undoStack().undo();
    QVERIFY(std::get<PaintLayer>(layer().mask->content).strokes.empty());
    mask.findChild<QCheckBox*>(QStringLiteral("maskInvert"))->click();
    QVERIFY(layer().mask->invert);
    mask.kinds().setCurrentIndex(0);
    emit mask.kinds().activated(0);
    QVERIFY(!layer().mask);
    painting.panel().findChild<QSpinBox*>(QStringLiteral("firstLevel"))->setValue(2);
    QCOMPARE(layer().firstLevel, 2);
}

void LayersPageTest::editsListsOfLights()
{
    Painting painting;
    painting.editor().addLayer({.name = "Lights", .content = PhongLightsLayer{}});
    SettingsForm& form = painting.panel().layers().form();
    auto* chooser = form.findChild<ItemChooser*>(QStringLiteral("lights"));
    QVERIFY(chooser);
    const auto lights = [&] { return std::get<PhongLightsLayer>(painting.editor().map()->layers[2].content).lights; };
    QCOMPARE(chooser->count(), 1);
    chooser->addButton().click();
    QCOMPARE(lights().size(), size_t{2});
    QCOMPARE(chooser->chosen(), 1);
    auto* azimuth = form.findChild<NumberField*>(QStringLiteral("azimuth"));
    QVERIFY(azimuth);
    emit azimuth->edited(30.0);
    emit azimuth->finished();
    QCOMPARE(lights()[1].azimuthDeg, 30.0);
    QCOMPARE(lights()[0].azimuthDeg, PhongLight{}.azimuthDeg);
    chooser->choose(0);
    QCOMPARE(azimuth->value(), PhongLight{}.azimuthDeg);
    chooser->removeButton().click();
    QCOMPARE(lights().size(), size_t{1});
    QCOMPARE(azimuth->value(), 30.0);
    painting.document().undoStack().undo();
    QCOMPARE(lights().size(), size_t{2});
}

void LayersPageTest::linesUpTheControlsOfAllForms()
{
    Painting painting;
    painting.editor().addLayer({.name = "Lights", .content = PhongLightsLayer{}}); // a light's fields stand in a form of their own
    const auto left = [&](const char* name) {
        const auto* control = painting.panel().findChild<QWidget*>(QLatin1String(name));
        return control->mapTo(&painting.panel(), QPoint()).x();
    };
    QTRY_COMPARE(left("intensity"), left("lights"));
    for (const char* name : {"exponent", "model", "ambient", "maskKind"})
        QCOMPARE(left(name), left("lights"));
}

void LayersPageTest::offersFilesToLayersThatReadThem()
{
    Painting painting;
    for (const char* kind : {"image", "probe"}) {
        painting.editor().addLayer({.content = makeContent(kind)});
        auto* source = painting.panel().layers().form().findChild<QLineEdit*>(QStringLiteral("source"));
        QVERIFY(source && source->findChild<QAction*>(QStringLiteral("chooseFile")));
    }
}

void LayersPageTest::parametersWithoutEffectAreHidden()
{
    Painting painting;
    painting.editor().addLayer({.content = ProbeLayer{.lobe = ProbeLobe::Mirror}});
    for (const char* field : {"exponent", "roughness", "index", "metal", "share"})
        QVERIFY2(!isShown(painting, field), field);
    pick(painting.panel().layers().form(), "fresnel", static_cast<int>(FresnelKind::Conductor));
    QVERIFY(isShown(painting, "metal") && isShown(painting, "share") && !isShown(painting, "index"));
    pick(painting.panel().layers().form(), "lobe", static_cast<int>(ProbeLobe::Phong));
    QVERIFY(isShown(painting, "exponent") && !isShown(painting, "roughness"));
    painting.editor().addLayer({.content = GradientLayer{}});
    QVERIFY(isShown(painting, "azimuth") && !isShown(painting, "angle") && !isShown(painting, "center-x") && !isShown(painting, "radius"));
    pick(painting.panel().layers().form(), "shape", static_cast<int>(GradientShape::Linear));
    QVERIFY(!isShown(painting, "azimuth") && isShown(painting, "angle") && isShown(painting, "center-x"));
    painting.editor().addLayer({.content = ColorgramLayer{}});
    QVERIFY(isShown(painting, "rings") && !isShown(painting, "pitch"));
    pick(painting.panel().layers().form(), "source", static_cast<int>(ColorgramSource::Grating));
    QVERIFY(!isShown(painting, "rings") && isShown(painting, "pitch") && !isShown(painting, "groove-angle"));
}

void LayersPageTest::namesThatThereAreAreOffered()
{
    Painting painting;
    painting.editor().addLayer({.content = ProbeLayer{.fresnel = FresnelKind::Conductor}});
    auto* metal = painting.panel().layers().form().findChild<QComboBox*>(QStringLiteral("metal"));
    QVERIFY(metal && metal->count() > 3);
    QCOMPARE(metal->currentData().toString(), QStringLiteral("gold"));
    const int other = metal->findData(QStringLiteral("copper"));
    QVERIFY(other >= 0);
    pick(painting.panel().layers().form(), "metal", other);
    QCOMPARE(std::get<ProbeLayer>(painting.editor().chosenLayer()->content).metal, std::string("copper"));
    auto* source = painting.panel().layers().form().findChild<QLineEdit*>(QStringLiteral("source"));
    QAction* offer = source->findChild<QAction*>(QStringLiteral("chooseSuggestion"));
    QVERIFY(offer);
    QTimer::singleShot(0, qApp, [] {
        if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget()))
            for (QAction* action : menu->actions())
                if (action->text() == QStringLiteral("builtin:sky")) {
                    menu->setActiveAction(action);
                    QTest::keyClick(menu, Qt::Key_Return);
                }
    });
    offer->trigger();
    QCOMPARE(std::get<ProbeLayer>(painting.editor().chosenLayer()->content).source, std::string("builtin:sky"));
}

void LayersPageTest::anotherLayersParametersBeginAtTheirTop()
{
    Painting painting;
    painting.editor().addLayer({.content = ToonLayer{}, .mask = Mask{}});
    painting.editor().addLayer({.content = ToonLayer{}, .mask = Mask{}});
    QScrollBar* bar = nullptr;
    for (QWidget* up = &painting.panel().layers().form(); up && !bar; up = up->parentWidget())
        if (auto* scroll = qobject_cast<QScrollArea*>(up))
            bar = scroll->verticalScrollBar();
    QVERIFY(bar);
    QTRY_VERIFY2(bar->maximum() > 100, qPrintable(QString::number(bar->maximum())));
    bar->setValue(bar->maximum());
    painting.editor().choose(2);
    QCOMPARE(bar->value(), 0);
    bar->setValue(bar->maximum());
    painting.editor().addLayer({.content = HatchingLayer{}});
    QCOMPARE(bar->value(), 0);
}

// A dock of a screen 1080 pixels high; the parameters of a fill need little room.
void LayersPageTest::theListShowsTheLayersThatThereAre()
{
    Painting painting;
    painting.window()->dock(QStringLiteral("sphere-map"))->resize(380, 1000);
    for (int i = 0; i < 5; ++i)
        painting.editor().addLayer({.blend = BlendMode::Darken, .content = FillLayer{}});
    LayerList& list = painting.panel().layers().list();
    QTRY_VERIFY2(list.viewport()->height() >= 6 * list.sizeHintForRow(0), qPrintable(QString::number(list.viewport()->height())));
}

} // namespace mirrorball::test
