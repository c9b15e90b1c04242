#pragma once

#include "test_class.h"

namespace mirrorball::test {

class LayoutTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void choosingChangesNoSize_data();
    void choosingChangesNoSize();
    void nothingIsCutOnASmallScreen_data();
    void nothingIsCutOnASmallScreen();
    void dialogsAreWhole_data();
    void dialogsAreWhole();
    void whatTheBarHasNoRoomForIsInAMenu();
    void keysRaiseATabThatLiesBehind();
    void keysOutsideThePictureChangeNothing();
    void aKeyOnThePictureSaysWhatItDid();
    void exposureHasAWayBack();
    void upToDateIsSaidWhenThePictureIs();
    void aFrameOfAnotherSizeIsNotStretched();
    void aMaterialThatIsReplacedSaysSo();
    void oneThingHasOneWord();
};

} // namespace mirrorball::test
