#pragma once

#include "test_class.h"

namespace mirrorball::test {

class RecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void keepsUnsavedChangesAndDropsSavedOnes();
    void leavesNothingAfterAnOrderlyEnd();
    void offersWhatAKilledProgramLeft();
    void leavesAloneWhatAnotherLivingProgramChanges();
};

/// What a program does until it is killed: edits and saves `file`, over and over, with copies in `folder`. Never returns.
[[noreturn]] void saveForever(const QString& file, const QString& folder);

} // namespace mirrorball::test
