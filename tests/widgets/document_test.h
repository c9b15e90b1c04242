#pragma once

#include "test_class.h"

namespace mirrorball::test {

class DocumentTest : public QObject {
    Q_OBJECT

private slots:
    void undoAndRedoExchangeTheScene();
    void oneDragIsOneStep();
    void aDragThatComesBackLeavesNoStep();
    void tellsWhichPartsChanged();
    void refusesAnInvalidEditAndKeepsTheScene();
    void savesPathsBelowItsFolderRelative();
    void picturesOfItsSphereMapAreFoundAfterSavingMovingAndUndoing();
    void aFileThatCannotBeReadLeavesTheDocumentAsItWas();
};

} // namespace mirrorball::test
