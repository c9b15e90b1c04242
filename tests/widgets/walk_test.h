#pragma once

#include "test_class.h"

namespace mirrorball::test {

class WalkTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void fromTheFirstStartToAnEnginesFiles();
};

} // namespace mirrorball::test
