#pragma once

#include "core/spheremap/strokes/stroke_canvas.h"
#include "evaluate.h"

#include <map>
#include <optional>
#include <utility>

namespace mirrorball {

/// The picture of a document while an artist works on it: the same bytes as evaluate(), but a change evaluates again only what it reached.
///
/// A stroke: the tiles that it touched, and where layers above move the picture, what these reach. A parameter: the layers from the changed
/// one up; from the second change of a layer on, what lies below is kept, and what the layers above give by themselves: so a slider costs
/// the changed layer, and laying those above over it.
class SphereMapCache {
public:
    /// @param options  `region`, `raster`, `drawn`, and the range of layers are not used. @throws InvalidArgument naming the field
    explicit SphereMapCache(const EvaluateOptions& options);

    /// Brings the picture to a document, which may differ from the last one in any way.
    /// @return the texels that may have changed; empty when nothing has
    /// @throws as evaluate(); the next update then starts afresh
    TexelRect update(const SphereMapDocument& document, const JobControl& job = {});

    /// With which image() is evaluated.
    const EvaluateOptions& options() const { return m_options; }
    int size() const { return m_options.size; }
    /// Edge of the level that the picture stands for.
    int levelSize() const { return m_options.levelSize > 0 ? m_options.levelSize : m_options.size; }
    const Image& image() const { return m_image; }
    /// The document of image(), or nothing.
    const std::optional<SphereMapDocument>& document() const { return m_document; }

private:
    using Painted = std::pair<size_t, PaintTarget>;

    TexelRect advance(const SphereMapDocument& document, const JobControl& job);
    EvaluateOptions withWhatIsKept() const;
    void keepCanvases(const SphereMapDocument& document, const JobControl& job);
    void keepBelow(const SphereMapDocument& document, size_t layer, const JobControl& job);
    void keepDrawn(const SphereMapDocument& document, size_t lowest, const std::vector<Painted>& redrawn, const JobControl& job);
    void evaluateInto(const SphereMapDocument& document, const TexelRect& rect, const JobControl& job);

    EvaluateOptions m_options;
    std::optional<SphereMapDocument> m_document{};
    Image m_image{};
    std::map<Painted, StrokeCanvas> m_canvases{}; ///< of visible paint layers and painted masks
    std::map<Painted, Image> m_drawn{};           ///< of other layers from the one up that is dragged
    size_t m_lastChanged = SIZE_MAX;              ///< the lowest layer of the last change
    Image m_below{};                              ///< layers below m_belowLayer, of m_document
    size_t m_belowLayer = 0;                      ///< 0: nothing is kept
};

} // namespace mirrorball
