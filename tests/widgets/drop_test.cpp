#include "drop_test.h"

#include "painting.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "core/image/map_file.h"
#include "widgets/controls/text.h"
#include "widgets/files/doctor_dialog.h"
#include "widgets/files/drop_mark.h"
#include "widgets/files/picture_question.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<DropTest> registered;

void DropTest::init()
{
    QSettings().clear();
    QApplication::clipboard()->clear();
}

namespace {

/// A square picture that says nothing of itself, and a panorama.
struct Pictures {
    TemporaryFolder folder;
    QString square, panorama;

    Pictures()
    {
        Image ball(48, 48, 3);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x)
                ball.texel(x, y)[y < 24 ? 0 : 2] = 0.8f;
        writeImage(folder / "ball.png", ball);
        writeImage(folder / "sky.hdr", renderBuiltinProbe("sky", {Parameterization::Latlong, 32, 0}).image);
        square = fromPath(folder / "ball.png");
        panorama = fromPath(folder / "sky.hdr");
    }
};

/// A drag as a file manager's, step by step.
class Drag {
public:
    explicit Drag(const QString& path) { m_data.setUrls({QUrl::fromLocalFile(path)}); }

    void over(QWidget& widget)
    {
        const QPoint at = widget.rect().center();
        QDragEnterEvent enter(at, Qt::CopyAction, &m_data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&widget, &enter);
        QVERIFY(enter.isAccepted());
        QDragMoveEvent move(at, Qt::CopyAction, &m_data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&widget, &move);
        QVERIFY(move.isAccepted());
    }
    static void leave(QWidget& widget)
    {
        QDragLeaveEvent leave;
        QApplication::sendEvent(&widget, &leave);
    }
    void dropOn(QWidget& widget)
    {
        over(widget);
        QDropEvent drop(widget.rect().center(), Qt::CopyAction, &m_data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&widget, &drop);
        QVERIFY(drop.isAccepted());
    }

private:
    QMimeData m_data;
};

/// Puts the panel back into the window and gives the layers the keys: a dock that floats is another window, which only a window manager
/// could make the active one.
LayerList& layersWithKeys(Painting& painting)
{
    QDockWidget* dock = painting.window()->dock(QStringLiteral("sphere-map"));
    dock->setFloating(false);
    dock->raise();
    QTest::qWait(50);
    QApplication::setActiveWindow(&*painting.window());
    painting.panel().layers().list().setFocus();
    return painting.panel().layers().list();
}

/// What the mark over a widget says, with a star where it is bright; empty where none is shown.
QString markOn(const QWidget& widget)
{
    const auto* mark = widget.findChild<DropMark*>(QString(), Qt::FindDirectChildrenOnly);
    return !mark || !mark->isVisible() ? QString() : (mark->isBright() ? QStringLiteral("* ") : QString()) + mark->text();
}

} // namespace

void DropTest::placesLightUpAndNameWhatWillHappen()
{
    const Pictures pictures;
    Painting painting;
    QWidget &disc = painting.canvas(), &layers = painting.panel().layers().list(), &preview = painting.window().preview();
    Drag square(pictures.square);
    square.over(layers);
    QCOMPARE(markOn(layers), QStringLiteral("* Image layer: ball.png"));
    QCOMPARE(markOn(disc), QStringLiteral("Sphere map of the material: ball.png"));
    keepScreenshot(painting.panel(), QStringLiteral("drop-layers"));
    square.over(disc);
    QCOMPARE(markOn(layers), QStringLiteral("Image layer: ball.png"));
    QCOMPARE(markOn(disc), QStringLiteral("* Sphere map of the material: ball.png"));
    square.over(preview);
    QCOMPARE(markOn(preview), QStringLiteral("* Sphere map of the material: ball.png")); // its dock is in front
    Drag panorama(pictures.panorama);
    panorama.over(preview);
    QCOMPARE(markOn(preview), QStringLiteral("* Light probe: sky.hdr"));
    keepScreenshot(*painting.window(), QStringLiteral("drop-probe"));
    painting.window()->dock(QStringLiteral("sphere-map"))->hide();
    QTRY_VERIFY(!painting.panel().isVisible());
    square.over(preview);
    QVERIFY2(markOn(preview).contains(QStringLiteral("Asks what ball.png is")), qPrintable(markOn(preview)));
}

void DropTest::theMarksGoWithTheDrag()
{
    const Pictures pictures;
    StudioWindow window;
    window.show();
    Drag drag(pictures.panorama);
    drag.over(window.preview());
    QVERIFY(!markOn(window.preview()).isEmpty());
    Drag::leave(window.preview());
    QVERIFY(markOn(window.preview()).isEmpty());
    drag.dropOn(window.preview());
    QVERIFY(markOn(window.preview()).isEmpty());
    drag.over(*window); // of the window itself, between all places: the picture's
    QCOMPARE(markOn(window.preview()), QStringLiteral("* Light probe: sky.hdr"));
}

void DropTest::aPictureOnTheLayersBecomesALayer()
{
    const Pictures pictures;
    Painting painting;
    const std::string probe = painting.document().scene().probe.source;
    const int before = painting.steps();
    Drag(pictures.square).dropOn(painting.panel().layers().list());
    QCOMPARE(painting.steps(), before + 1);
    QCOMPARE(painting.editor().map()->layers.size(), size_t(3));
    const Layer& top = painting.editor().map()->layers.back();
    QCOMPARE(QString::fromStdString(std::get<ImageLayer>(top.content).source), pictures.square);
    QCOMPARE(top.name, std::string("ball"));
    // A picture that is not square is cropped rather than refused.
    Drag(pictures.panorama).dropOn(painting.panel().layers().list());
    QCOMPARE(std::get<ImageLayer>(painting.editor().map()->layers.back().content).fit, Fit::Crop);
    painting.waitForPicture();
    QCOMPARE(painting.document().scene().probe.source, probe);
    QVERIFY(painting.window()->workspace().notices.all().isEmpty());
}

void DropTest::aPictureOnTheDiscBecomesTheMaterial()
{
    const Pictures pictures;
    for (const QString& picture : {pictures.square, pictures.panorama}) {
        Painting painting;
        const int before = painting.steps();
        Drag(picture).dropOn(painting.canvas());
        QCOMPARE(painting.steps(), before + 1);
        QCOMPARE(QString::fromStdString(painting.document().scene().material.sphereMap.source), picture);
        painting.window().waitForPicture();
        QVERIFY(painting.window()->workspace().notices.all().isEmpty()); // what is not square is cropped
        painting.document().undoStack().undo();
        QVERIFY(painting.editor().map());
    }
}

void DropTest::aPanoramaElsewhereIsTheLight()
{
    const Pictures pictures;
    Painting painting; // with the dock of the sphere map in front
    Drag(pictures.panorama).dropOn(painting.window().preview());
    QCOMPARE(QString::fromStdString(painting.document().scene().probe.source), pictures.panorama);
    QVERIFY(painting.editor().map());
}

void DropTest::aSquareAsksByPictures()
{
    const Pictures pictures;
    StudioWindow window;
    window.show();
    const Scene before = window.document().scene();
    const auto ask = [&]() -> PictureQuestion* {
        Drag(pictures.square).dropOn(window.preview());
        auto* question = window->findChild<PictureQuestion*>();
        return question && QTest::qWaitFor([&] { return !question->cards().isEmpty(); }, 30000) ? question : nullptr;
    };
    PictureQuestion* question = ask();
    QVERIFY(question);
    QStringList names;
    for (const QToolButton* card : question->cards()) {
        names << card->objectName().section(u'.', 1);
        QVERIFY2(!card->icon().isNull(), qPrintable(card->objectName()));
    }
    names.sort();
    QCOMPARE(names, (QStringList{QStringLiteral("angular"), QStringLiteral("ball"), QStringLiteral("octahedral"), QStringLiteral("sphere"),
                                 QStringLiteral("sphere-map")}));
    QVERIFY(unexplained(*question).isEmpty());
    keepScreenshot(*question, QStringLiteral("picture-question"));
    QTest::mouseClick(question->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel), Qt::LeftButton);
    QVERIFY(window.document().scene() == before);
    QTRY_VERIFY(!window->findChild<PictureQuestion*>());

    QVERIFY(question = ask());
    QTest::mouseClick(question->findChild<QToolButton*>(QStringLiteral("picture.octahedral")), Qt::LeftButton);
    QCOMPARE(QString::fromStdString(window.document().scene().probe.source), pictures.square);
    QCOMPARE(window.document().scene().probe.reading.parameterization, std::optional(Parameterization::Octahedral));
    QTRY_VERIFY(!window->findChild<PictureQuestion*>());
    QVERIFY(question = ask());
    QTest::mouseClick(question->findChild<QToolButton*>(QStringLiteral("picture.sphere-map")), Qt::LeftButton);
    QCOMPARE(QString::fromStdString(window.document().scene().material.sphereMap.source), pictures.square);
}

void DropTest::aPictureThatSaysWhatItIsIsNotAskedFor()
{
    const TemporaryFolder folder;
    const Image square = renderBuiltinProbe("sky", {Parameterization::Octahedral, 32, 0}).image;
    writeImage(folder / "light.exr", square, {.attributes = {{"mirrorball:parameterization", "octahedral"}}});
    writeImage(folder / "paint.exr", square,
               {.attributes = {{"mirrorball:parameterization", "sphere"}, {"mirrorball:index", "normal"}}}); // as exports write it
    StudioWindow window;
    window.show();
    Drag(fromPath(folder / "light.exr")).dropOn(window.preview());
    QCOMPARE(QString::fromStdString(window.document().scene().probe.source), fromPath(folder / "light.exr"));
    Drag(fromPath(folder / "paint.exr")).dropOn(window.preview());
    QCOMPARE(QString::fromStdString(window.document().scene().material.sphereMap.source), fromPath(folder / "paint.exr"));
    QVERIFY(!window->findChild<PictureQuestion*>());
}

// Qt's own fields would take the file's address for a text.
void DropTest::aFieldOfTextGetsNoFile()
{
    const Pictures pictures;
    StudioWindow window;
    window.show();
    auto* find = window->findChild<QLineEdit*>(QStringLiteral("probes.find"));
    Drag(pictures.panorama).dropOn(*find);
    QCOMPARE(find->text(), QString());
    QCOMPARE(QString::fromStdString(window.document().scene().probe.source), pictures.panorama);
}

// ---- clipboard -----------------------------------------------------------------------------------------------------------------

void DropTest::pastesAPicture()
{
    const TemporaryFolder folder;
    QImage picture(64, 64, QImage::Format_RGB32);
    picture.fill(QColor(200, 40, 20));
    Painting painting;
    QVERIFY(painting.window()->files().saveAs(fromPath(folder / "scene.mirrorball")));
    QApplication::clipboard()->setImage(picture);
    QTest::keyClick(&layersWithKeys(painting), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(painting.editor().map()->layers.size(), size_t(3));
    const QString source = QString::fromStdString(std::get<ImageLayer>(painting.editor().map()->layers.back().content).source);
    QVERIFY2(source.startsWith(fromPath(folder / "pasted")), qPrintable(source));
    QCOMPARE(QImage(source).pixelColor(3, 3), QColor(200, 40, 20));
    // Beside the picture it is asked for, as a drop there.
    painting.window()->dock(QStringLiteral("sphere-map"))->hide();
    QApplication::setActiveWindow(&*painting.window());
    painting.window().preview().setFocus();
    QTest::keyClick(&painting.window().preview(), Qt::Key_V, Qt::ControlModifier);
    QVERIFY(painting.window()->findChild<PictureQuestion*>());
}

void DropTest::copiesPastesAndDuplicatesLayers()
{
    const Pictures pictures;
    QApplication::clipboard()->clear();
    {
        Painting painting;
        QVERIFY(painting.window()->files().saveAs(fromPath(pictures.folder / "scene.mirrorball")));
        Drag(pictures.square).dropOn(painting.panel().layers().list());
        QVERIFY(painting.window()->files().save()); // in the file the path is relative
        QVERIFY(painting.window()->files().openScene(fromPath(pictures.folder / "scene.mirrorball")));
        QVERIFY(
            !QFileInfo(QString::fromStdString(std::get<ImageLayer>(painting.editor().map()->layers.back().content).source)).isAbsolute());
        QTest::keyClick(&layersWithKeys(painting), Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(painting.editor().map()->layers.size(), size_t(4));
        QVERIFY(painting.editor().map()->layers[2] == painting.editor().map()->layers[3]);
        QTest::keyClick(&painting.panel().layers().list(), Qt::Key_C, Qt::ControlModifier);
        QTest::keyClick(&painting.panel().layers().list(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(painting.editor().map()->layers.size(), size_t(5));
        QVERIFY(painting.editor().map()->layers[4] == painting.editor().map()->layers[3]);
    }
    Painting elsewhere; // another scene, without a file
    QTest::keyClick(&layersWithKeys(elsewhere), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(elsewhere.editor().map()->layers.size(), size_t(3));
    // Paths of a scene without a file start at the current folder.
    const QFileInfo pasted(QString::fromStdString(std::get<ImageLayer>(elsewhere.editor().map()->layers.back().content).source));
    QCOMPARE(pasted.canonicalFilePath(), QFileInfo(pictures.square).canonicalFilePath());
    elsewhere.waitForPicture();
    QVERIFY(elsewhere.window()->workspace().notices.all().isEmpty());
}

void DropTest::fieldsKeepTheClipboard()
{
    Painting painting;
    QApplication::clipboard()->setText(QStringLiteral("sky"));
    auto* find = painting.window()->findChild<QLineEdit*>(QStringLiteral("probes.find"));
    QApplication::setActiveWindow(&*painting.window());
    find->setFocus();
    const int before = painting.steps();
    QTest::keyClick(find, Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(find->text(), QStringLiteral("sky"));
    QCOMPARE(painting.steps(), before);
}

// ---- the doctor ----------------------------------------------------------------------------------------------------------------

void DropTest::aMapOfLevelsMayBeAskedFor()
{
    const TemporaryFolder folder;
    std::vector<EnvironmentMap> levels;
    for (int size = 32; size >= 1; size /= 2)
        levels.push_back(renderBuiltinProbe("sky", {Parameterization::Cube, size, 0}));
    writeMap(folder / "levels.exr", levels);
    StudioWindow window;
    window.show();
    Drag(fromPath(folder / "levels.exr")).dropOn(window.preview());
    QTRY_VERIFY(window->findChild<QPushButton*>() != nullptr);
    const auto& notices = window->workspace().notices.all();
    const auto notice = std::find_if(notices.begin(), notices.end(), [](const Notices::Notice& n) { return n.subject == u"doctor"; });
    QVERIFY(notice != notices.end());
    QVERIFY2(notice->text.contains(QStringLiteral("8 levels")), qPrintable(notice->text)); // OpenEXR's own, of 32 x 192 texels
    const auto act = notice->action;
    act();
    auto* doctor = window->findChild<DoctorDialog*>();
    QVERIFY(doctor);
    QTRY_VERIFY_WITH_TIMEOUT(!doctor->text().isEmpty(), 60000);
    QVERIFY2(doctor->text().contains(QStringLiteral("cube")), qPrintable(doctor->text()));
    QVERIFY(unexplained(*doctor).isEmpty());
    keepScreenshot(*doctor, QStringLiteral("doctor"));
}

} // namespace mirrorball::test
