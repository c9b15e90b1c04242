#include "main_window.h"
#include "theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QLocale>
#include <QTranslator>

#include <algorithm>
#include <cstring>
#include <memory>

namespace {

/// Whether the program only says something and ends: that needs no display.
bool asksForText(int count, char** arguments)
{
    return std::any_of(arguments + 1, arguments + count, [](const char* argument) {
        return std::strcmp(argument, "--help") == 0 || std::strcmp(argument, "-h") == 0 || std::strcmp(argument, "--help-all") == 0 ||
               std::strcmp(argument, "--version") == 0 || std::strcmp(argument, "-v") == 0;
    });
}

} // namespace

int main(int count, char** arguments)
{
    using namespace mirrorball::studio;
    QCoreApplication::setOrganizationName(QStringLiteral("mirrorball"));
    QCoreApplication::setApplicationName(QStringLiteral("mirrorball-studio"));
    QCoreApplication::setApplicationVersion(QStringLiteral(MIRRORBALL_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("org.mirrorball.Studio"));
    const bool onlyText = asksForText(count, arguments);
    const std::unique_ptr<QCoreApplication> application(onlyText ? new QCoreApplication(count, arguments)
                                                                 : new QApplication(count, arguments));

    QTranslator translator;
    if (translator.load(QLocale(), QStringLiteral("mirrorball-studio"), QStringLiteral("_"),
                        QCoreApplication::applicationDirPath() + QStringLiteral("/../share/mirrorball/translations")))
        QCoreApplication::installTranslator(&translator);

    QCommandLineParser parser;
    parser.setApplicationDescription(QCoreApplication::translate("main", "Author materials with environment maps: the desktop tool."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("FILE"),
        QCoreApplication::translate(
            "main", "What to open: a scene, a light probe or another picture, a folder of them, a mesh, a sphere map, a material."),
        QStringLiteral("[FILE...]"));
    parser.process(*application);

    applyTheme(static_cast<QApplication&>(*application));
    MainWindow window;
    window.show();
    const QStringList files = parser.positionalArguments();
    window.openFiles(files);
    if (files.isEmpty()) // who opens a file knows the way
        window.greet();
    return QCoreApplication::exec();
}
