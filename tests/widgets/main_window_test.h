#pragma once

#include "test_class.h"

namespace mirrorball::test {

class MainWindowTest : public QObject {
    Q_OBJECT

private slots:
    void showsThePictureThatTheCommandLineDraws();
};

} // namespace mirrorball::test
