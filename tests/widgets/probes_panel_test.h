#pragma once

#include "test_class.h"

namespace mirrorball::test {

class ProbesPanelTest : public QObject {
    Q_OBJECT

private slots:
    void filesThatAreGoneCanBeTakenOffTheList();
    void init();
    void listsTheBuiltInProbesWithThumbnails();
    void choosingAProbeIsAnUndoStep();
    void keysChooseToo();
    void tellsTheFactsOfTheProbe();
    void takesAFileThatIsDropped();
    void takesAFolderThatIsDroppedAndFollowsIt();
    void refusesOtherFilesInWords();
    void offersAPictureOfEachGuess();
    void offersAMirrorBallForAPhotograph();
    void namesWhatIsBroken();
    void readsAProbeAgainThatChangedOnDisk();
    void keepsThumbnailsOnDisk();
    void saysWhyAListIsEmpty();
    void namesAllControls();
};

} // namespace mirrorball::test
