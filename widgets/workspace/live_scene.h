#pragma once

#include "document.h"
#include "job_runner.h"

#include "core/preview/display_transform.h"
#include "core/preview/mesh.h"
#include "core/scene/live_maps.h"

#include <QTimer>

#include <memory>

namespace mirrorball::studio {

/// A scene with its maps and the mesh that it is shown on: all that a picture needs.
struct PreparedScene : MadeScene {
    std::shared_ptr<const preview::Mesh> mesh{}; ///< null for a built-in body
    std::string meshProblem{};                   ///< why the mesh file could not be read: what it held before, or a box, stands in
    std::shared_ptr<const preview::DisplayTransform> display{}; ///< null for tone curve and sRGB
    std::string displayProblem{}; ///< why the display's configuration could not be used: sRGB then stands in for it
};

/// Follows a document: makes its plan and its maps in the background, coarse while a control is dragged and full when it comes to rest.
/// What widgets show of maps, plan and times comes from made().
class LiveScene : public QObject {
    Q_OBJECT

public:
    explicit LiveScene(Document& document, QObject* parent = nullptr);

    /// The newest result; null before the first. It may be of an older scene than the document's.
    std::shared_ptr<const PreparedScene> made() const { return m_made; }
    /// Whether made() is of the document's scene, in full.
    bool isUpToDate() const { return m_isUpToDate; }
    JobRunner& runner() { return m_runner; }
    /// Makes everything anew that changed on disk.
    void refresh();
    /// Stops the work that is under way; the next edit starts it again.
    void stop() { m_runner.stop(); }

signals:
    /// made() changed.
    void updated();
    /// The scene could not be made, and why; made() is as before.
    void failed(const QString& message);

private:
    struct Maker;
    void follow();
    void request();
    void use(std::shared_ptr<const PreparedScene> made);
    bool startsAnew() const;

    Document& m_document;
    JobRunner m_runner;
    std::shared_ptr<Maker> m_maker; ///< touched on the worker only
    std::shared_ptr<const PreparedScene> m_made;
    Scene m_requested{}; ///< what the newest request is of
    MapDetail m_requestedDetail{};
    bool m_isUpToDate = false;
};

} // namespace mirrorball::studio
