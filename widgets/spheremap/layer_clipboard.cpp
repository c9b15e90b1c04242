#include "layer_clipboard.h"

#include "core/spheremap/document/sphere_map_file.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>

namespace mirrorball::studio {

namespace {

const QString layersMime = QStringLiteral("application/x-mirrorball-layers");
const std::filesystem::path anywhere = "/"; ///< paths of layers that are on their way start here

} // namespace

void copyLayer(const SphereMapEditor& editor)
{
    const Layer* layer = editor.chosenLayer();
    if (!layer)
        return;
    SphereMapDocument one;
    one.folder = editor.map()->folder;
    one.layers = {*layer};
    const QString text = QString::fromStdString(sphereMapToText(movedTo(std::move(one), anywhere)));
    auto* data = new QMimeData;
    data->setData(layersMime, text.toUtf8());
    data->setText(text);
    QApplication::clipboard()->setMimeData(data);
}

bool hasCopiedLayers()
{
    const QMimeData* data = QApplication::clipboard()->mimeData();
    return data && data->hasFormat(layersMime);
}

void pasteLayers(SphereMapEditor& editor)
{
    const QMimeData* data = QApplication::clipboard()->mimeData();
    SphereMapDocument pasted = sphereMapFromText(data->data(layersMime).toStdString());
    pasted.folder = anywhere;
    if (!editor.map()) {
        editor.setMap(SphereMapEditor::tr("Paste layers"), pasted);
        return;
    }
    for (const Layer& layer : movedTo(std::move(pasted), editor.map()->folder).layers)
        editor.addLayer(layer);
}

} // namespace mirrorball::studio
