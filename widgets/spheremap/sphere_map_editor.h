#pragma once

#include "widgets/picture/screen_picture.h"
#include "widgets/workspace/document.h"
#include "widgets/workspace/job_runner.h"
#include "widgets/workspace/live_scene.h"

#include "core/spheremap/evaluation/levels_cache.h"
#include "core/spheremap/strokes/stroke_recorder.h"

#include <QObject>

#include <QPointF>
#include <QTabletEvent>

#include <memory>
#include <optional>
#include <vector>

namespace mirrorball::studio {

/// What a press of the pen does.
enum class PaintTool { Paint, Erase, Smudge, PickColor };

/// Which end of a pen touches.
enum class PenEnd { Tip, Eraser };

/// What a pen says besides its place; a mouse presses fully and stands upright.
struct PenTouch {
    double pressure = 1.0; ///< [0, 1]
    PenEnd end = PenEnd::Tip;
    glm::dvec2 tilt{0.0}; ///< degrees to the right and up, as StrokePoint has it
};
PenTouch penTouch(const QTabletEvent& event);

/// A brush that is changed by a drag: across its radius, up and down its hardness. @param moved  since the press, in pixels
Brush draggedBrush(const Brush& before, const QPointF& moved);

inline constexpr double longestStabilizer = 100.0; ///< pixels
/// The stabilizer that was set last, by whichever window: a habit of the hand.
double keptStabilizer();

/// The sphere map of the document's scene while an artist works on it: which layer is chosen, with what is painted, and the picture, live.
///
/// Every change is an edit of the document; a stroke is one undo step that keeps the stroke and no more. The picture is evaluated in the
/// background, only where a change reached, and follows a stroke while it is drawn. Canvas, panel and preview share one of these.
class SphereMapEditor : public QObject {
    Q_OBJECT

public:
    /// @param live  made of the document: while a control is dragged it evaluates the map for the model, and the picture is taken from
    /// there
    SphereMapEditor(Document& document, LiveScene& live, QObject* parent = nullptr);
    ~SphereMapEditor() override;

    /// The scene's own sphere map; null when it has none.
    const SphereMapDocument* map() const { return m_map.get(); }
    /// Gives the scene a sphere map of its own in place of whatever it has.
    void setMap(const QString& label, const SphereMapDocument& map);
    /// One undo step. Edits of the same non-empty key merge until finishEdit(): a drag.
    void edit(const QString& label, const QString& mergeKey, const std::function<void(SphereMapDocument&)>& change);
    void finishEdit() { m_document.finishEdit(); }

    /// Index of the chosen layer; -1 without layers.
    int chosen() const { return m_chosen; }
    void choose(int layer);
    const Layer* chosenLayer() const;
    /// Of a layer that is a list of lights, which one: chosen in its form or on the disc.
    int chosenLight() const { return m_light; }
    void chooseLight(int light);
    /// Changes the chosen layer.
    void editLayer(const QString& label, const QString& mergeKey, const std::function<void(Layer&)>& change);
    /// Puts a layer above the chosen one and chooses it.
    void addLayer(const Layer& layer);
    void duplicateChosen();
    void removeChosen();
    /// @param to  the index it has afterwards
    void moveLayer(int from, int to);

    const Brush& brush() const { return m_brush; }
    void setBrush(const Brush& brush);
    /// Makes the tip larger or smaller by steps of 15 %.
    void stepBrush(int steps);
    const Symmetry& symmetry() const { return m_symmetry; }
    void setSymmetry(const Symmetry& symmetry);
    /// Length of the string that the brush hangs on (PulledString), in pixels of the widget that is painted in, [0, longestStabilizer]; 0:
    /// it is where the pointer is. No part of a stroke, which keeps where the brush went.
    double stabilizer() const { return m_stabilizer; }
    void setStabilizer(double pixels);
    PaintTool tool() const { return m_tool; }
    void setTool(PaintTool tool);

    /// Whether the pen paints on the model in the preview; otherwise it turns it.
    bool paintsOnModel() const { return m_paintsOnModel; }
    void setPaintsOnModel(bool on);

    /// Where strokes of the chosen layer go: to itself, or to its mask if that is painted and either wanted or all there is to paint on.
    std::optional<PaintTarget> paintTarget() const;
    void setPaintsMask(bool on);

    /// Whether a stroke can begin: a layer is chosen and shown that can be painted on. Otherwise paintingProblem() says what to do.
    bool canPaint() const { return paintingProblem().isEmpty(); }
    QString paintingProblem() const;
    /// A stroke of the chosen layer, of places that are steadied already. @param leap  see StrokeRecorder
    void beginStroke(const StrokePoint& point, PenEnd end = PenEnd::Tip, double leap = 8.0);
    void moveStroke(const StrokePoint& point);
    /// The pen left the model; the stroke may go on elsewhere.
    void liftStroke();
    /// The stroke becomes an undo step.
    void endStroke();
    void cancelStroke();
    bool isPainting() const { return m_recorder.has_value(); }
    /// The color that the picture shows at a place of the disc becomes the brush's.
    void pickColor(const glm::dvec2& q);

    /// The one level of the chain that disc and model show, and that strokes go to; empty: all of them, as the picture needs them.
    std::optional<int> onlyLevel() const { return m_onlyLevel; }
    /// A level beyond the last is the last.
    void showOnly(std::optional<int> level);
    /// That level for the screen, texel by texel; null where none is shown alone, or before it is made.
    const QImage& levelPicture() const { return m_levelScreen; }
    /// "Level 3 only: 128 x 128"; empty where none is.
    QString onlyLevelText() const;
    /// Levels of the chain.
    int levelCount() const;

    /// Edge of the picture, in texels: that of the map that the scene's picture reads.
    int size() const { return m_size; }
    /// The picture, RGBA, linear, colors multiplied by their opacity; empty before the first. It may be of an older state, and has fewer
    /// texels than size() while something is dragged.
    const Image& picture() const { return m_picture; }
    /// The same for the screen.
    const ScreenPicture& screen() const { return m_screen; }
    /// The coarser levels of a hand-made chain, of which only what levelsChanged() named since a stroke began is there.
    const std::vector<Image>& coarserLevels() const { return m_coarser; }
    bool isUpToDate() const { return !m_runner.isBusy() && !m_awaitsLive; }

signals:
    /// map() changed.
    void mapChanged();
    void chosenChanged();
    void lightChanged();
    void brushChanged();
    void toolChanged();
    /// onlyLevel() changed.
    void onlyLevelChanged();
    /// levelPicture() changed.
    void levelPictureChanged();
    /// picture() changed within these texels.
    void pictureChanged(const mirrorball::TexelRect& touched);
    /// coarserLevels() changed: rectangles of levels 1, 2, ...; empty where nothing did. Only while a stroke is drawn.
    void levelsChanged(const std::vector<mirrorball::TexelRect>& touched);
    /// The picture could not be made, and why; empty: it was made.
    void problemChanged(const QString& problem);

private:
    void follow();
    void followLive();
    void request();

    struct Patch {
        TexelRect rect{};
        int size = 0; ///< of the whole
        Image image{};
        QImage screen{};
        std::vector<LevelPatch> levels{};
        Image only{}; ///< the level that is shown alone, where it is an average of the picture
    };
    void show(Patch patch);
    void showLevel(Image average);
    void prepareLevelLayer();

    Document& m_document;
    LiveScene& m_live;
    bool m_awaitsLive = false; ///< the picture of map() comes from there
    bool m_hasSkipped = false; ///< what is kept to evaluate strokes fast is of an older map
    std::shared_ptr<const SphereMapDocument> m_map;
    int m_chosen = -1;
    int m_light = 0;
    Brush m_brush{};
    Symmetry m_symmetry{};
    double m_stabilizer = keptStabilizer();
    PaintTool m_tool = PaintTool::Paint;
    bool m_paintsOnModel = false;
    bool m_paintsMask = false;
    std::optional<int> m_onlyLevel{};
    Image m_levelImage{}; ///< of onlyLevel(), where that is not the largest
    QImage m_levelScreen{};
    int m_size = 0;
    std::optional<StrokeRecorder> m_recorder;
    size_t m_recorderLayer = 0;
    PaintTarget m_recorderTarget = PaintTarget::Layer;
    Image m_picture{};
    ScreenPicture m_screen{};
    std::vector<Image> m_coarser{};
    std::shared_ptr<SphereMapCache> m_cache;      ///< touched on the worker only
    std::shared_ptr<LevelsCache> m_levelsCache{}; ///< the same; null until a stroke needs it
    JobRunner m_runner;                           ///< last: it ends first
};

} // namespace mirrorball::studio
