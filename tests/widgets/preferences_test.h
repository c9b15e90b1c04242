#pragma once

#include "test_class.h"

namespace mirrorball::test {

class PreferencesTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void aCommandGetsAnotherKeyAndKeepsIt();
    void aKeyThatIsTakenStaysWhereItIs();
    void aPlainKeyWorksOnThePictureAlone();
    void keysAreResetOneByOneAndAll();
    void commandsAreFound();
    void aMousePresetMovesTheCamera_data();
    void aMousePresetMovesTheCamera();
    void theWipesLineIsDraggedWhateverThePreset();
    void unsavedChangesAreKeptWhenItIsSaid();
    void everyControlExplainsItself();
};

} // namespace mirrorball::test
