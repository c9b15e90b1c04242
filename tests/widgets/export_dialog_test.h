#pragma once

#include "test_class.h"

namespace mirrorball::test {

class ExportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void everyChangeIsAnUndoStepOfTheScene();
    void keepsFormatsAndFileNamesTogether();
    void namesTheFilesAndSizesBeforehand();
    void itsCommandLineWritesTheSameBytes();
    void writesOnlyWhatIsChecked();
    void stopsWhenCancelled();
    void saysWhatIsWrong();
    void offersThePaintedMapWhereThereIsOne();
    void writesThePaintedMapAsPaintDoes();
    void keepsWhatEachKindUnderstands();
    void beginsWithAGalleryOfEngines();
    void anEnginesFilesAreTheCommandLines();
    void namesAllControls();
};

} // namespace mirrorball::test
