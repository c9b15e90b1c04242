#pragma once

#include "test_class.h"

namespace mirrorball::test {

class JobRunnerTest : public QObject {
    Q_OBJECT

private slots:
    void worksOffTheGuiThreadAndDeliversOnIt();
    void theNewestRequestWins();
    void aShortRunningRequestMayFinish();
    void stopsAndSaysSo();
    void reportsErrorsInWords();
};

} // namespace mirrorball::test
