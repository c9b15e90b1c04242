#pragma once

#include "test_class.h"

namespace mirrorball::test {

class PaintedExportTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void writesThePictureThatTheMenuIsAskedFor();
    void tellsWhatIsWrongByANotice();
};

} // namespace mirrorball::test
