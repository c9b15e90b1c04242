#pragma once

#include "test_class.h"

namespace mirrorball::test {

class ComparisonTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void snapshotsHaveNamesAndPictures();
    void aSnapshotIsRenamedAndDeletedByKeys();
    void sideBySideShowsBothWhole();
    void thePictureSaysWhichIsWhich();
    void theFiguresAreThoseOfWhatIsShown();
    void theFiguresWaitWhileSomethingMoves();
    void aSnapshotIsBroughtBackInOneStep();
    void aSnapshotKeepsItsFolder();
    void sideBySideThePenTouchesWhatIsShownNow();
};

} // namespace mirrorball::test
