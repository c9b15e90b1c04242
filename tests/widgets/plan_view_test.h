#pragma once

#include "test_class.h"

namespace mirrorball::test {

class PlanViewTest : public QObject {
    Q_OBJECT

private slots:
    void showsWhatIsLeftOutAndHowLongTheRestTook();
    void saysWhatWasKept();
    void followsTheDocument();
};

} // namespace mirrorball::test
