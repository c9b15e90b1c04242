#pragma once

#include "test_class.h"

namespace mirrorball::test {

class WholeJobTest : public QObject {
    Q_OBJECT

private slots:
    void fromADroppedProbeToTheMapsThatTheCommandLineWrites();
};

} // namespace mirrorball::test
