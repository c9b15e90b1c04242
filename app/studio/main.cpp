#include "main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>

int main(int count, char** arguments)
{
    using namespace mirrorball::studio;
    QSurfaceFormat::setDefaultFormat(previewFormat());
    QApplication application(count, arguments);
    QApplication::setApplicationName(QStringLiteral("mirrorball-studio"));
    QApplication::setApplicationVersion(QStringLiteral(MIRRORBALL_VERSION));

    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate("main", "Author materials with environment maps."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FILE"), QApplication::translate("main", "scene file (.mirrorball), probe or mesh to open"));
    parser.process(application);

    MainWindow window;
    window.show();
    return QApplication::exec();
}
