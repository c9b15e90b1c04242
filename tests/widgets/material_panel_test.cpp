#include "material_panel_test.h"

#include "file_dialog_answer.h"

#include "core/image/image_io.h"
#include "core/scene/material_presets.h"
#include "core/scene/scene_file.h"
#include "support/temporary_folder.h"
#include "widgets/controls/text.h"
#include "widgets/panels/fresnel_curve.h"
#include "widgets/panels/material_panel.h"
#include "widgets/panels/view_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<MaterialPanelTest> registered;

/// Moves a control as a user would. @return false for one that only opens a dialog
static bool operate(QWidget* control)
{
    if (auto* number = qobject_cast<NumberField*>(control)) {
        QTest::keyClick(number->box(), number->value() < number->box()->maximum() ? Qt::Key_Up : Qt::Key_Down);
        emit number->finished();
        return true;
    }
    if (auto* spin = qobject_cast<QSpinBox*>(control)) {
        spin->stepUp();
        return true;
    }
    if (auto* check = qobject_cast<QCheckBox*>(control)) {
        check->click();
        return true;
    }
    if (auto* combo = qobject_cast<QComboBox*>(control)) {
        const int next = combo->currentIndex() == 0 ? 1 : 0;
        combo->setCurrentIndex(next);
        emit combo->activated(next);
        return true;
    }
    if (auto* color = qobject_cast<ColorButton*>(control)) {
        emit color->edited({0.25, 0.5, 0.75});
        emit color->finished();
        return true;
    }
    if (auto* line = qobject_cast<QLineEdit*>(control)) { // a BRDF, a picture
        line->setText(QStringLiteral("ggx:alpha=0.25"));
        emit line->editingFinished();
        return true;
    }
    if (auto* box = control->findChild<NumberBox*>()) { // three numbers
        box->stepUp();
        return true;
    }
    return false;
}

/// An OpenColorIO configuration with two views of one display.
static std::string writeDisplayConfig(const TemporaryFolder& folder)
{
    writeBytes(folder / "two_views.ocio", "ocio_profile_version: 1\n"
                                          "roles:\n  scene_linear: linear\n"
                                          "displays:\n  monitor:\n"
                                          "    - !<View> {name: plain, colorspace: linear}\n"
                                          "    - !<View> {name: raised, colorspace: gamma}\n"
                                          "active_displays: [monitor]\nactive_views: [plain, raised]\n"
                                          "colorspaces:\n"
                                          "  - !<ColorSpace>\n    name: linear\n"
                                          "  - !<ColorSpace>\n    name: gamma\n"
                                          "    from_reference: !<ExponentTransform> {value: [0.5, 0.5, 0.5, 1]}\n");
    return (folder / "two_views.ocio").string();
}

void MaterialPanelTest::aDisplayConfigurationIsReadInTheBackgroundAndChosenFrom()
{
    const TemporaryFolder folder;
    Workspace workspace;
    ViewPanel view(workspace);
    auto* displays = qobject_cast<QComboBox*>(view.form().control(QStringLiteral("view.display")));
    QCOMPARE(displays->count(), 2);
    auto* bodies = qobject_cast<QComboBox*>(view.form().control(QStringLiteral("view.geometry")));
    QVERIFY(!workspace.meshes.isBusy()); // nobody sees the list yet, and the first picture comes first
    view.show();
    QTRY_VERIFY(!bodies->itemIcon(bodies->findData(QStringLiteral("torus"))).isNull());
    view.openDisplayConfig(QString::fromStdString(writeDisplayConfig(folder)));
    QTRY_COMPARE(displays->count(), 4);
    QCOMPARE(displays->currentText(), QStringLiteral("monitor: plain"));
    displays->setCurrentIndex(2);
    emit displays->activated(2);
    QCOMPARE(workspace.document.scene().view.display.view, std::string("raised"));
    QTRY_VERIFY_WITH_TIMEOUT(workspace.live.isUpToDate(), 30000);
    QVERIFY(workspace.live.made()->display && workspace.live.made()->displayProblem.empty());
    workspace.document.undoStack().undo();
    QCOMPARE(displays->currentText(), QStringLiteral("monitor: plain"));
    workspace.document.undoStack().undo();
    QCOMPARE(displays->currentIndex(), 0);
}

void MaterialPanelTest::everyControlIsOneStepThatCanBeUndone()
{
    const TemporaryFolder folder;
    const std::string config = writeDisplayConfig(folder);
    for (const FresnelKind kind : {FresnelKind::None, FresnelKind::Dielectric, FresnelKind::Conductor})
        for (const SurfaceLobe lobe : {SurfaceLobe::Mirror, SurfaceLobe::Phong, SurfaceLobe::Ggx}) {
            Workspace workspace;
            workspace.document.edit(QStringLiteral("start"), {}, [&](Scene& scene) {
                scene.material.fresnel.kind = kind;
                scene.material.fresnel.metal = "custom";
                scene.material.specular.lobe = lobe;
                scene.view.background.kind = Backdrop::Blurred;
                scene.material.lambda = 1.0;
                scene.view.display.config = config;
            });
            MaterialPanel material(workspace);
            ViewPanel view(workspace);
            auto* displays = qobject_cast<QComboBox*>(view.form().control(QStringLiteral("view.display")));
            QTRY_COMPARE(displays->count(), 4); // sRGB, two views, another file
            const Scene before = workspace.document.scene();
            for (OptionsForm* form : {&material.form(), &view.form()})
                for (QWidget* control : form->findChildren<QWidget*>()) {
                    if (form->control(control->objectName()) != control || control->isHidden())
                        continue;
                    const int steps = workspace.document.undoStack().index();
                    QVERIFY2(operate(control), qPrintable(control->objectName()));
                    QVERIFY2(workspace.document.scene() != before, qPrintable(control->objectName()));
                    QCOMPARE(workspace.document.undoStack().index(), steps + 1);
                    workspace.document.undoStack().undo();
                    QVERIFY2(workspace.document.scene() == before, qPrintable(control->objectName()));
                }
        }
}

static NumberField* numberField(MaterialPanel& panel, const char* path)
{
    return qobject_cast<NumberField*>(panel.form().control(QLatin1String(path)));
}

void MaterialPanelTest::theExponentIsLogarithmic()
{
    Workspace workspace;
    workspace.document.edit(QStringLiteral("phong"), {}, [](Scene& scene) { scene.material.specular.lobe = SurfaceLobe::Phong; });
    MaterialPanel panel(workspace);
    NumberField* exponent = numberField(panel, "material.specular.exponent");
    QVERIFY(exponent && !exponent->isHidden());
    exponent->slider()->setValue(0);
    QCOMPARE(workspace.document.scene().material.specular.exponent, 0.1);
    exponent->slider()->setValue(exponent->slider()->maximum());
    QCOMPARE(workspace.document.scene().material.specular.exponent, 1e6);
    exponent->slider()->setValue(exponent->slider()->maximum() / 7);         // one of seven decades
    QCOMPARE(workspace.document.scene().material.specular.exponent, 0.9991); // 10000/7 is no whole position
    exponent->box()->selectAll();
    QTest::keyClicks(exponent->box(), QStringLiteral("123.5\r"));
    QCOMPARE(workspace.document.scene().material.specular.exponent, 123.5);
}

void MaterialPanelTest::aSliderDragIsOneStepAndADoubleClickResets()
{
    Workspace workspace;
    MaterialPanel panel(workspace);
    panel.resize(360, 700);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    NumberField* weight = numberField(panel, "material.specular.weight");
    QSlider* slider = weight->slider();
    const int y = slider->height() / 2;
    QTest::mousePress(slider, Qt::LeftButton, {}, {slider->width() / 4, y});
    for (int x = slider->width() / 4; x < slider->width() * 3 / 4; x += 5)
        QTest::mouseMove(slider, {x, y});
    QVERIFY(workspace.document.isDragging());
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() * 3 / 4, y});
    QVERIFY(!workspace.document.isDragging());
    QCOMPARE(workspace.document.undoStack().count(), 1);
    QVERIFY(workspace.document.scene().material.specular.weight > 1.2);
    QTest::mouseDClick(slider, Qt::LeftButton, {}, {slider->width() / 8, y});
    QCOMPARE(workspace.document.scene().material.specular.weight, 1.0);
    workspace.document.undoStack().undo();
    QVERIFY(workspace.document.scene().material.specular.weight > 1.2);
}

void MaterialPanelTest::stepsByKeysWithModifiers()
{
    Workspace workspace;
    MaterialPanel panel(workspace);
    NumberField* weight = numberField(panel, "material.diffuse.weight");
    QTest::keyClick(weight->box(), Qt::Key_Up);
    QCOMPARE(workspace.document.scene().material.diffuse.weight, 0.01);
    emit weight->finished();
    const NumberStyle style{.high = 1e6, .sliderLow = 0.1, .sliderHigh = 1e6, .scale = Scale::Logarithmic, .initial = 1.0};
    NumberField exponent(style);
    exponent.show();
    QVERIFY(QTest::qWaitForWindowExposed(&exponent));
    exponent.box()->stepBy(20);
    QVERIFY(std::abs(exponent.value() - 10.0) < 1e-9); // twenty steps a decade
}

void MaterialPanelTest::presetsSetTheWholeMaterial()
{
    Workspace workspace;
    MaterialPanel panel(workspace);
    auto* presets = panel.findChild<QComboBox*>(QStringLiteral("materialPresets"));
    for (const MaterialPreset& preset : materialPresets()) {
        const int index = presets->findData(toQString(preset.name));
        QVERIFY(index > 0);
        presets->setCurrentIndex(index);
        emit presets->activated(index);
        QVERIFY(workspace.document.scene().material == preset.material);
        QCOMPARE(presets->currentIndex(), index);
    }
    workspace.document.edit(QStringLiteral("own"), {}, [](Scene& scene) { scene.material.lambda = 1.5; });
    QCOMPARE(presets->currentIndex(), 0); // "Custom material"
    workspace.document.undoStack().undo();
    QVERIFY(presets->currentIndex() > 0);
}

void MaterialPanelTest::indexPresetsAndMetals()
{
    Workspace workspace;
    workspace.document.edit(QStringLiteral("glass"), {}, [](Scene& scene) { scene.material.fresnel.kind = FresnelKind::Dielectric; });
    MaterialPanel panel(workspace);
    for (QToolButton* button : panel.findChildren<QToolButton*>())
        if (button->text() == QStringLiteral("Diamond"))
            button->click();
    QCOMPARE(workspace.document.scene().material.fresnel.index, 2.417);
    QVERIFY(panel.form().control(QStringLiteral("material.fresnel.metal"))->isHidden());

    workspace.document.edit(QStringLiteral("metal"), {}, [](Scene& scene) { scene.material.fresnel.kind = FresnelKind::Conductor; });
    auto* metals = qobject_cast<QComboBox*>(panel.form().control(QStringLiteral("material.fresnel.metal")));
    QVERIFY(!metals->isHidden());
    const int custom = metals->findData(QStringLiteral("custom"));
    emit metals->activated(custom); // starts from gold
    QCOMPARE(workspace.document.scene().material.fresnel.metal, std::string("custom"));
    QCOMPARE(workspace.document.scene().material.fresnel.n.r, 0.22337);
    QVERIFY(!panel.form().control(QStringLiteral("material.fresnel.n"))->isHidden());
}

void MaterialPanelTest::materialFilesRoundTrip()
{
    const TemporaryFolder folder;
    Workspace workspace;
    MaterialPanel panel(workspace);
    workspace.document.edit(QStringLiteral("own"), {}, [](Scene& scene) { scene.material = findMaterialPreset("car-paint")->material; });
    const Material material = workspace.document.scene().material;
    panel.saveMaterialAs(fromPath(folder / "m.json"));
    workspace.document.undoStack().undo();
    panel.openMaterial(fromPath(folder / "m.json"));
    QVERIFY(workspace.document.scene().material == material);
    panel.openMaterial(fromPath(folder / "none.json"));
    QVERIFY(workspace.notices.all().size() == 1 && workspace.notices.all().front().text.contains(QStringLiteral("none.json")));
}

void MaterialPanelTest::theCurveFollowsTheMaterial()
{
    Workspace workspace;
    studio::FresnelCurve curve(workspace.document); // not the one of core/shading
    curve.resize(260, 150);
    const QImage none = curve.grab().toImage();
    workspace.document.edit(QStringLiteral("glass"), {}, [](Scene& scene) { scene.material.fresnel.kind = FresnelKind::Dielectric; });
    const QImage glass = curve.grab().toImage();
    workspace.document.edit(QStringLiteral("gold"), {}, [](Scene& scene) { scene.material.fresnel.kind = FresnelKind::Conductor; });
    const QImage gold = curve.grab().toImage();
    QVERIFY(none != glass && glass != gold);
}

void MaterialPanelTest::aPictureIsAFileAndNeedsTextureCoordinates()
{
    const TemporaryFolder folder;
    writeImage(folder / "grey.exr", Image(2, 2, 3, 0.5f));
    writeBytes(folder / "bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto write = [](const std::string& geometry) {
        return [geometry](Scene& scene) {
            scene.material.diffuse.weight = 1.0;
            scene.view.geometry = geometry;
        };
    };
    Workspace workspace;
    MaterialPanel panel(workspace);
    workspace.document.edit(QStringLiteral("diffuse"), {}, write("torus"));
    auto* picture = qobject_cast<QLineEdit*>(panel.form().control(QStringLiteral("material.diffuse.picture")));
    QVERIFY(picture);
    const int steps = workspace.document.undoStack().index();
    const FileDialogAnswer answer(fromPath(folder / "grey.exr"));
    picture->findChild<QAction*>(QStringLiteral("chooseFile"))->trigger();
    QTRY_COMPARE(workspace.document.scene().material.diffuse.picture, (folder / "grey.exr").string());
    QCOMPARE(workspace.document.undoStack().index(), steps + 1);
    QCOMPARE(picture->text(), fromPath(folder / "grey.exr"));
    const auto made = [&] { return workspace.live.made(); };
    QTRY_VERIFY_WITH_TIMEOUT(workspace.live.isUpToDate(), 30000);
    QVERIFY(made()->plan.diffusePicture);
    QCOMPARE(made()->maps.diffusePicture->front().texels.front(), 0.5f);
    QVERIFY(made()->meshProblem.empty());
    workspace.document.edit(QStringLiteral("mesh"), {}, write((folder / "bare.obj").string()));
    QTRY_VERIFY_WITH_TIMEOUT(workspace.live.isUpToDate(), 30000);
    QVERIFY2(made()->meshProblem.find("material.diffuse.picture") != std::string::npos, made()->meshProblem.c_str());
    QVERIFY(!made()->plan.diffusePicture); // it is shown without
    workspace.document.undoStack().undo();
    workspace.document.undoStack().undo();
    QVERIFY(picture->text().isEmpty());
}

} // namespace mirrorball::test
