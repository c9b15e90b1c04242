#include "document_test.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/scene/scene_file.h"
#include "core/spheremap/evaluation/evaluate.h"
#include "support/temporary_folder.h"
#include "widgets/controls/text.h"
#include "widgets/workspace/document.h"

#include <QSignalSpy>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<DocumentTest> registered;

static void setExponent(Document& document, double exponent, const QString& key = {})
{
    document.edit(QStringLiteral("exponent"), key, [=](Scene& scene) { scene.material.specular.exponent = exponent; });
}

void DocumentTest::undoAndRedoExchangeTheScene()
{
    Document document;
    setExponent(document, 7);
    const Scene after = document.scene();
    QVERIFY(document.isModified());
    document.undoStack().undo();
    QVERIFY(document.scene() == newScene());
    QVERIFY(!document.isModified());
    document.undoStack().redo();
    QVERIFY(document.scene() == after);
}

void DocumentTest::oneDragIsOneStep()
{
    Document document;
    for (int i = 1; i <= 100; ++i)
        setExponent(document, i, QStringLiteral("exponent"));
    QVERIFY(document.isDragging());
    document.finishEdit();
    QVERIFY(!document.isDragging());
    setExponent(document, 200, QStringLiteral("exponent"));
    document.finishEdit();
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QCOMPARE(document.scene().material.specular.exponent, 100.0);
    document.undoStack().undo();
    QCOMPARE(document.scene().material.specular.exponent, Scene{}.material.specular.exponent);
}

void DocumentTest::aDragThatComesBackLeavesNoStep()
{
    Document document;
    const double before = document.scene().material.specular.exponent;
    setExponent(document, 99, QStringLiteral("exponent"));
    setExponent(document, before, QStringLiteral("exponent"));
    document.finishEdit();
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(!document.isModified());
}

void DocumentTest::tellsWhichPartsChanged()
{
    Document document;
    QSignalSpy changed(&document, &Document::changed);
    document.edit(QStringLiteral("view"), {}, [](Scene& scene) { scene.view.exposure = 1.0; });
    QCOMPARE(changed.size(), 1);
    QCOMPARE(changed.front().front().value<Parts>(), Parts(Part::View));
    document.edit(QStringLiteral("nothing"), {}, [](Scene&) {});
    QCOMPARE(changed.size(), 1);
}

void DocumentTest::refusesAnInvalidEditAndKeepsTheScene()
{
    Document document;
    QSignalSpy refused(&document, &Document::refused);
    document.edit(QStringLiteral("bad"), {}, [](Scene& scene) { scene.material.fresnel.metal = "adamant"; });
    QCOMPARE(refused.size(), 1);
    QVERIFY(refused.front().front().toString().contains(QStringLiteral("material.fresnel.metal")));
    QVERIFY(document.scene() == newScene());
    QCOMPARE(document.undoStack().count(), 0);
}

void DocumentTest::savesPathsBelowItsFolderRelative()
{
    const TemporaryFolder folder;
    const std::filesystem::path probe = folder / "sky.hdr";
    Document document;
    document.edit(QStringLiteral("probe"), {}, [&](Scene& scene) { scene.probe.source = probe.string(); });
    document.save(fromPath(folder / "a.mirrorball"));
    QVERIFY(!document.isModified());
    const Scene read = loadScene(folder / "a.mirrorball");
    QCOMPARE(QString::fromStdString(read.probe.source), QStringLiteral("sky.hdr"));
    QCOMPARE(resolved(read, read.probe.source), probe.string());
    QVERIFY(document.scene() == read);
    document.undoStack().undo();
    QVERIFY(document.isModified());
}

void DocumentTest::picturesOfItsSphereMapAreFoundAfterSavingMovingAndUndoing()
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "project");
    std::filesystem::create_directory(folder / "other");
    Image ball(2, 2, 3);
    ball.texels.assign(ball.texels.size(), 0.25f);
    writeImage(folder / "project" / "ball.exr", ball);
    const auto shown = [](const Scene& scene) { return evaluate(*scene.material.sphereMap.document.document, {.size = 1}).texels[0]; };
    Document document;
    document.edit(QStringLiteral("map"), {}, [&](Scene& scene) {
        SphereMapDocument map;
        map.layers = {{.content = ImageLayer{.source = (folder / "project" / "ball.exr").string()}}};
        scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(map));
    });
    setExponent(document, 7);
    document.save(fromPath(folder / "project" / "a.mirrorball"));
    QCOMPARE(std::get<ImageLayer>(document.scene().material.sphereMap.document.document->layers[0].content).source,
             std::string("ball.exr"));
    QCOMPARE(shown(document.scene()), 0.25f);
    document.undoStack().undo();
    QCOMPARE(shown(document.scene()), 0.25f);
    document.undoStack().redo();
    setExponent(document, 8);
    document.save(fromPath(folder / "other" / "b.mirrorball"));
    QCOMPARE(shown(document.scene()), 0.25f);
    document.undoStack().undo();
    document.undoStack().undo();
    QCOMPARE(shown(document.scene()), 0.25f);
    document.save(fromPath(folder / "project" / "a.mirrorball"));
    std::filesystem::rename(folder / "project", folder / "moved");
    QCOMPARE(shown(loadScene(folder / "moved" / "a.mirrorball")), 0.25f);
}

void DocumentTest::aFileThatCannotBeReadLeavesTheDocumentAsItWas()
{
    const TemporaryFolder folder;
    writeBytes(folder / "broken.mirrorball", "{");
    Document document;
    setExponent(document, 7);
    QVERIFY_EXCEPTION_THROWN(document.load(fromPath(folder / "broken.mirrorball")), FileError);
    QCOMPARE(document.scene().material.specular.exponent, 7.0);
    QVERIFY(document.filePath().isEmpty());
    QVERIFY(document.isModified());
}

} // namespace mirrorball::test
