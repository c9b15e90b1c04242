#pragma once

#include "test_class.h"

namespace mirrorball::test {

class DropTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void placesLightUpAndNameWhatWillHappen();
    void theMarksGoWithTheDrag();
    void aPictureOnTheLayersBecomesALayer();
    void aPictureOnTheDiscBecomesTheMaterial();
    void aPanoramaElsewhereIsTheLight();
    void aSquareAsksByPictures();
    void aPictureThatSaysWhatItIsIsNotAskedFor();
    void aFieldOfTextGetsNoFile();
    void pastesAPicture();
    void copiesPastesAndDuplicatesLayers();
    void fieldsKeepTheClipboard();
    void aMapOfLevelsMayBeAskedFor();
};

} // namespace mirrorball::test
