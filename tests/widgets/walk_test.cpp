#include "walk_test.h"

#include "file_dialog_answer.h"
#include "painting.h"
#include "studio_window.h"
#include "widget_driver.h"

#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/text.h"
#include "widgets/exports/export_dialog.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFileInfo>
#include <QListWidget>
#include <QMenu>
#include <QProcess>
#include <QScrollArea>
#include <QSignalSpy>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<WalkTest> registered;

void WalkTest::init() { QSettings().clear(); } // whoever starts has never been here

namespace {

/// A newcomer: sees, clicks, drags and types, and knows nothing of the code behind.
class Newcomer {
public:
    explicit Newcomer(StudioWindow& window) : m_window(window) {}

    template <typename Control>
    Control& find(const char* name)
    {
        auto* control = m_window->findChild<Control*>(QLatin1String(name));
        if (!control)
            qFatal("there is no %s", name);
        return *control;
    }

    /// Brings a control into sight: its dock to the front, the dock's content to where it is.
    template <typename Control>
    Control& see(const char* dock, const char* name)
    {
        auto& control = find<Control>(name);
        QAction& raise = find<QAction>(qPrintable(QStringLiteral("window.") + QLatin1String(dock)));
        if (!m_window->dock(QLatin1String(dock))->widget()->isVisible())
            keys(raise.shortcut());
        if (!QTest::qWaitFor([&] { return control.isVisible(); }, 3000))
            qFatal("%s is not seen", name);
        for (QWidget* at = control.parentWidget(); at; at = at->parentWidget())
            if (auto* scroll = qobject_cast<QScrollArea*>(at))
                scroll->ensureWidgetVisible(&control);
        return control;
    }

    /// A key with its modifiers, to whatever has the keys.
    void keys(const QKeySequence& key)
    {
        QApplication::setActiveWindow(&*m_window); // there is no window manager that would
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &*m_window, key[0].key(), key[0].keyboardModifiers());
    }
    void onPicture(Qt::Key key)
    {
        m_window.preview().setFocus();
        keys(QKeySequence(key));
    }

    void choose(const char* dock, const char* name, const QString& item)
    {
        auto& combo = see<QComboBox>(dock, name);
        const int index = combo.findText(item, Qt::MatchContains);
        QVERIFY2(index >= 0, qPrintable(item));
        QTest::mouseClick(&combo, Qt::LeftButton);
        QTRY_VERIFY(combo.view()->isVisible());
        const QModelIndex row = combo.model()->index(index, combo.modelColumn());
        combo.view()->scrollTo(row);
        QTest::qWait(QApplication::doubleClickInterval() > 0 ? 20 : 0);
        QTest::mouseMove(combo.view()->viewport(), combo.view()->visualRect(row).center());
        QTest::keyClick(combo.view(), Qt::Key_Escape); // the list was looked at; the keys choose
        combo.setFocus();
        for (int tries = 0; combo.currentIndex() != index && tries < combo.count(); ++tries)
            QTest::keyClick(&combo, combo.currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
        QCOMPARE(combo.currentIndex(), index);
    }

    void type(const char* dock, const char* name, const QString& text)
    {
        auto& number = see<NumberField>(dock, name);
        QTest::mouseDClick(number.box(), Qt::LeftButton);
        number.box()->setFocus();
        number.box()->selectAll();
        QTest::keyClicks(number.box(), text + u'\r');
    }

    /// Clicks a button that opens a menu, and chooses an item of it by keys.
    void pick(QToolButton& button, const QString& item)
    {
        bool isPicked = false;
        QTimer look;
        QObject::connect(&look, &QTimer::timeout, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (!menu || isPicked)
                return;
            for (QAction* action : menu->actions())
                if (action->text().remove(u'&') == item) {
                    isPicked = true;
                    for (int tries = 0; menu->activeAction() != action && tries < 100; ++tries)
                        QTest::keyClick(menu, Qt::Key_Down);
                    QTest::keyClick(menu, Qt::Key_Return);
                }
        });
        look.start(20);
        QTest::mouseClick(&button, Qt::LeftButton); // back when the menu is closed
        QTRY_VERIFY2(isPicked, qPrintable(item));
    }

    /// Clicks a command in a tool bar.
    void click(const char* command)
    {
        QAction& action = find<QAction>(command);
        for (QObject* place : action.associatedObjects())
            if (auto* bar = qobject_cast<QToolBar*>(place)) {
                QWidget* button = bar->widgetForAction(&action);
                if (!button->isVisible()) // there is no room for it: it is in the menu at the bar's end
                    pick(*bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button")), action.text().remove(u'&'));
                else
                    QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        QFAIL(command);
    }

private:
    StudioWindow& m_window;
};

float largest(const Image& image) { return *std::max_element(image.texels.begin(), image.texels.end()); }

/// What the newcomer does, step by step: each goes on where the one before it stopped.
class Walk {
public:
    Walk()
    {
        writeImage(m_folder / "room.hdr", renderBuiltinProbe("cube-room", {Parameterization::Latlong, 64, 0}).image);
        m_window.show();
        m_window->greet(); // as main() does where no file is opened
    }

    /// The tour is offered, and follows what is done.
    void followsTheTour()
    {
        QVERIFY(m_tour.isVisible());
        QCOMPARE(m_tour.step(), 0);
        {
            FileDialogAnswer answer(m_probe);
            m_newcomer.keys(m_newcomer.find<QAction>("file.open").shortcut());
            QVERIFY(answer.isDone());
        }
        QCOMPARE(QString::fromStdString(m_document.scene().probe.source), m_probe);
        QCOMPARE(m_tour.step(), 1);
        m_window.waitForPicture();
        Painting::drag(&m_window.preview(), middle(), middle() + QPoint(120, 0), Qt::RightButton, Qt::ShiftModifier);
        QVERIFY(m_document.scene().probe.yawDeg != 0.0);
        QCOMPARE(m_tour.step(), 2);
    }

    void makesACoatedMaterial()
    {
        m_newcomer.choose("material", "material.specular.lobe", QStringLiteral("Phong"));
        m_newcomer.type("material", "material.specular.exponent", QStringLiteral("200"));
        m_newcomer.choose("material", "material.fresnel.kind", QStringLiteral("Dielectric"));
        m_newcomer.type("material", "material.fresnel.index", QStringLiteral("1.5"));
        m_newcomer.choose("material", "material.combine", QStringLiteral("Coat"));
        QCOMPARE(m_tour.step(), 3);
        m_newcomer.choose("map", "map.parameterization", QStringLiteral("araboloid"));
        QCOMPARE(m_tour.step(), 4);
        m_newcomer.click("torus");
        const Material& material = m_document.scene().material;
        QCOMPARE(material.specular.exponent, 200.0);
        QCOMPARE(material.fresnel.index, 1.5);
        QCOMPARE(material.combine, Combine::Coat);
        QCOMPARE(m_document.scene().map.parameterization, Parameterization::Paraboloid);
        QCOMPARE(QString::fromStdString(m_document.scene().view.geometry), QStringLiteral("torus"));
        m_window.waitForPicture();
        m_newcomer.keys(m_newcomer.find<QAction>("compare.snapshot").shortcut());
        QCOMPARE(m_window->workspace().snapshots.all().size(), size_t(1));
    }

    /// A toon matcap from nothing, and a color brighter than the screen.
    void makesAToonMatcapAndABrightBrush()
    {
        QTest::mouseClick(&m_newcomer.see<QWidget>("sphere-map", "newSphereMap"), Qt::LeftButton);
        QVERIFY(m_editor.map());
        m_newcomer.pick(m_newcomer.see<QToolButton>("sphere-map", "addLayer"), QStringLiteral("Toon bands"));
        m_newcomer.pick(m_newcomer.see<QToolButton>("sphere-map", "addLayer"), QStringLiteral("Paint"));
        QCOMPARE(m_editor.map()->layers.size(), size_t(4));
        QTRY_VERIFY_WITH_TIMEOUT(m_editor.isUpToDate(), 20000);
        for (QWidget* swatch : m_window->dock(QStringLiteral("sphere-map"))->findChildren<QWidget*>())
            if (swatch->accessibleName() == QStringLiteral("Brush color"))
                QTest::mouseClick(swatch, Qt::LeftButton);
        auto& hex = m_newcomer.see<QLineEdit>("color", "color.hex"); // the brush is black at first, which no intensity makes brighter
        hex.setFocus();
        hex.selectAll();
        QTest::keyClicks(&hex, QStringLiteral("#ffffff\r"));
        m_newcomer.type("color", "color.ev", QStringLiteral("3"));
        const glm::dvec3 color = m_editor.brush().color;
        QVERIFY2(std::max({color.r, color.g, color.b}) > 1.0,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(color.r).arg(color.g).arg(color.b)));
    }

    /// Where it is to be seen.
    void paintsAHighlightOnTheModel()
    {
        const QImage unpainted = m_window.picture();
        m_newcomer.click("paintOnModel");
        QVERIFY(m_editor.paintsOnModel());
        const int rim = m_window.preview().height() / 5; // the torus has a hole in its middle
        const QPoint body = middle() + QPoint(0, rim);
        const int before = m_document.undoStack().index();
        Painting::drag(&m_window.preview(), body, body + QPoint(30, 4));
        QCOMPARE(m_document.undoStack().index(), before + 1);
        QTRY_VERIFY_WITH_TIMEOUT(m_editor.isUpToDate(), 20000);
        QVERIFY(largestDifference(m_window.picture(), unpainted) > 20);
        QVERIFY(largest(m_window->workspace().live.made()->maps.sphereMaps.front()->levels.front()) > 1.0f);
        m_newcomer.click("paintOnModel");
    }

    void goesTenStepsBackAndForth()
    {
        const Scene painted = m_document.scene();
        const int steps = m_document.undoStack().index();
        QVERIFY(steps >= 10);
        m_window.preview().setFocus();
        for (int i = 0; i < 10; ++i)
            m_newcomer.keys(QKeySequence::Undo);
        QCOMPARE(m_document.undoStack().index(), steps - 10);
        QVERIFY(m_document.scene().material.sphereMap.isNone());
        for (int i = 0; i < 10; ++i)
            m_newcomer.keys(QKeySequence::Redo);
        QVERIFY(m_document.scene() == painted);
    }

    void putsTheCoatBesideTheToon()
    {
        m_newcomer.onPicture(Qt::Key_S);
        const QImage both = m_window.picture();
        const int half = both.width() / 2;
        QVERIFY(largestDifference(both.copy(0, 0, half, both.height()), both.copy(both.width() - half, 0, half, both.height())) > 20);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->workspace().snapshots.error(), 10000);
        QVERIFY(m_window->workspace().snapshots.error()->ssim < 0.999);
        keepScreenshot(*m_window, QStringLiteral("walk"));
        m_newcomer.onPicture(Qt::Key_S);
    }

    void savesTheScene()
    {
        {
            FileDialogAnswer answer(m_scene);
            m_newcomer.keys(m_newcomer.find<QAction>("file.save").shortcut());
            QVERIFY(answer.isDone());
        }
        QCOMPARE(m_document.filePath(), m_scene);
    }

    /// And the tour is at its end.
    void exportsForAnEngine()
    {
        m_newcomer.keys(m_newcomer.find<QAction>("file.export").shortcut());
        auto* dialog = m_window->findChild<ExportDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        auto& gallery = *dialog->findChild<QListWidget*>(QStringLiteral("export.gallery"));
        for (int row = 0; row < gallery.count() && (!dialog->engine() || dialog->engine()->word != "filament"); ++row) {
            gallery.scrollToItem(gallery.item(row));
            QTest::mouseClick(gallery.viewport(), Qt::LeftButton, {}, gallery.visualItemRect(gallery.item(row)).center());
        }
        QVERIFY(dialog->engine() && dialog->engine()->word == "filament");
        auto& size = *dialog->findChild<QComboBox*>(QStringLiteral("engine.size"));
        size.setFocus();
        QTest::keyClick(&size, Qt::Key_Home);
        auto& place = *dialog->findChild<QLineEdit*>(QStringLiteral("export.folder"));
        place.setFocus();
        place.selectAll();
        for (const char* side : {"here", "there"})
            std::filesystem::create_directory(m_folder / side);
        QTest::keyClicks(&place, fromPath(m_folder / "here" / "light")); // the folder's name is the export's
        QTest::keyClick(&place, Qt::Key_Tab);
        QTRY_VERIFY_WITH_TIMEOUT(dialog->isEstimated(), 20000);
        QSignalSpy exported(dialog, &ExportDialog::exported);
        QTest::mouseClick(dialog->findChild<QWidget*>(QStringLiteral("export.start")), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!exported.isEmpty(), patience);
        QVERIFY(!m_tour.isRunning());
        m_command = dialog->command();
        m_exported = exported.front().front().toStringList();
        dialog->close();
    }

    /// The engine's files, and the picture.
    void hasTheSameBytesWithoutAWindow()
    {
        const std::filesystem::path ours = m_folder / "ours.png";
        m_window->savePicture(fromPath(ours));
        QString command = m_command;
        command.replace(fromPath(m_folder / "here"), fromPath(m_folder / "there"));
        QProcess shell;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("PATH"),
                           QFileInfo(QStringLiteral(MIRRORBALL_PROGRAM)).absolutePath() + u':' + environment.value(QStringLiteral("PATH")));
        shell.setProcessEnvironment(environment);
        shell.start(QStringLiteral("/bin/sh"),
                    {QStringLiteral("-c"),
                     command + QStringLiteral(" && mirrorball render '%1' -o '%2'").arg(m_scene, fromPath(m_folder / "theirs.png"))});
        QVERIFY(shell.waitForFinished(patience));
        QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
        QVERIFY(m_exported.size() >= 2);
        for (const QString& file : m_exported) {
            const std::string name = QFileInfo(file).fileName().toStdString();
            const std::string here = readBytes(m_folder / "here" / "light" / name), there = readBytes(m_folder / "there" / "light" / name);
            QVERIFY2(!here.empty() && here == there, name.c_str());
        }
        QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(ours), patience);
        QVERIFY(readBytes(ours) == readBytes(m_folder / "theirs.png"));
    }

private:
    QPoint middle() { return m_window.preview().rect().center(); }

    TemporaryFolder m_folder{};
    QString m_probe = fromPath(m_folder / "room.hdr"), m_scene = fromPath(m_folder / "job.mirrorball");
    StudioWindow m_window{};
    Newcomer m_newcomer{m_window};
    Document& m_document = m_window.document();
    Tour& m_tour = m_window->tour();
    SphereMapEditor& m_editor = m_window->workspace().sphereMap;
    QStringList m_exported{}; ///< the engine's files
    QString m_command{};      ///< that makes them, as the dialog says
};

} // namespace

void WalkTest::fromTheFirstStartToAnEnginesFiles()
{
    Walk walk;
    for (void (Walk::*const step)() : {&Walk::followsTheTour, &Walk::makesACoatedMaterial, &Walk::makesAToonMatcapAndABrightBrush,
                                       &Walk::paintsAHighlightOnTheModel, &Walk::goesTenStepsBackAndForth, &Walk::putsTheCoatBesideTheToon,
                                       &Walk::savesTheScene, &Walk::exportsForAnEngine, &Walk::hasTheSameBytesWithoutAWindow}) {
        (walk.*step)();
        if (QTest::currentTestFailed())
            return;
    }
}

} // namespace mirrorball::test
