#include "recovery_test.h"
#include "test_class.h"

#include "app/studio/theme.h"

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <cstdio>
#include <cstring>

/// widget_tests [CLASS [arguments of QtTest]]
int main(int count, char** arguments)
{
    if (count == 4 && std::strcmp(arguments[1], "--save-forever") == 0) {
        QCoreApplication killed(count, arguments);
        mirrorball::test::saveForever(QString::fromLocal8Bit(arguments[2]), QString::fromLocal8Bit(arguments[3]));
    }
    QStandardPaths::setTestModeEnabled(true); // settings and caches of a user are left alone
    QApplication application(count, arguments);
    QApplication::setOrganizationName(QStringLiteral("mirrorball-test"));
    QApplication::setApplicationName(QStringLiteral("widget_tests"));
    const QTemporaryDir settings; // classes run side by side, and some begin by clearing the settings
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());

    mirrorball::studio::applyTheme(application);

    QStringList rest = QCoreApplication::arguments();
    const QString wanted = rest.size() > 1 ? rest.takeAt(1) : QString();
    int failed = 0, ran = 0;
    for (const auto& make : mirrorball::test::testClasses()) {
        const auto tests = make();
        const QString name = QString::fromLatin1(tests->metaObject()->className()).section(QStringLiteral("::"), -1);
        if (!wanted.isEmpty() && name != wanted)
            continue;
        failed += QTest::qExec(tests.get(), rest);
        ++ran;
    }
    if (ran == 0)
        std::fprintf(stderr, "no test class is called %s\n", qPrintable(wanted));
    return failed == 0 && ran > 0 ? 0 : 1;
}
