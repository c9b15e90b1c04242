#pragma once

#include "live_picture.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mirrorball {

/// A scene with everything that was made of it. A value; maps are shared, so a copy is cheap.
struct MadeScene {
    Scene scene{};
    Plan plan{};
    SceneMaps maps{};
    WorkRecord record{}; ///< of this update only
    MapDetail detail{};
    MapLayout probeLayout{};
    std::shared_ptr<const EnvironmentMap> environment{}; ///< the probe as it is; null when nothing needs it or it was streamed
    RepairReport repaired{};
    std::string origin{}; ///< how its parameterization was found, in words
    bool certain = true;  ///< false: a guess by the shape alone
    std::string
        problem{}; ///< why the probe, a sphere map or a picture could not be read: the maps then show what it held before, or a placeholder
    /// Files that could be read before and cannot be any more: what they held then is shown.
    std::vector<std::string> keptFiles{};
};

/// The maps of a scene that is being edited: an update makes what an edit touched and keeps the rest. A map that did not change comes
/// back as the same pointer, so that the renderer keeps its texture; the probe is read again only when its file changed, and its spectrum
/// is kept from lobe to lobe. One thread at a time.
class LiveMaps {
public:
    /// A file that cannot be read is named in `problem`. One that could be before is shown as it was; in place of any other probe
    /// placeholderProbe() is.
    /// @throws InvalidArgument naming the field, when the scene is not valid; Cancelled, after which the next update goes on from what
    ///         is there
    MadeScene update(const Scene& scene, const MapDetail& detail, const JobControl& job = {});

private:
    /// What a probe was read from. A file is told by its time and size, too.
    struct ProbeKey {
        std::string path{};
        ProbeReading reading{};
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;
        bool operator==(const ProbeKey&) const = default;
    };
    struct KeptMap {
        MapPlan key{}; ///< what of its plan the map depends on
        double exposure = 0.0;
        MapLevels levels{};
    };
    struct KeptBrdf {
        BrdfPlan plan{};
        std::string path{}; ///< of a measurement
        std::filesystem::file_time_type time{};
        double exposure = 0.0; ///< of the stack
        std::shared_ptr<const Image> table{};
        std::shared_ptr<const ViewStack> stack{}; ///< in place of the table where it is exact
        std::string problem{}; ///< why the file could not be read: a white mirror stands in, or light of 1 from everywhere
    };
    struct KeptSphereMap {
        SphereMapPlan plan{};
        std::string path{};
        std::filesystem::file_time_type time{};
        SphereMapChain texels{};
        std::string problem{}; ///< why the file could not be read, or what of it is left out
        bool isKept = false;   ///< the texels are those of the file as it was before
        /// Of a document inside the scene, which may change with every movement of a slider: as large as it is, and as its coarser picture.
        std::shared_ptr<SphereMapCache> cache{}, coarseCache{};
    };

    /// A probe's file, as far as it has been read, and the maps that were made of it.
    struct Opened {
        MapLayout layout{};
        bool isStreamed = false;
        SceneProbe probe{};                                  ///< its source serves the filters
        MapLevels itself{};                                  ///< the probe as it is, one level
        std::shared_ptr<const EnvironmentMap> environment{}; ///< that level
        bool certain = true;
        KeptMap specular{}, diffuse{}, clearCoat{}, background{};
        std::optional<KeptBrdf> exact{}; ///< of this probe, as the maps are

        bool holdsLight() const { return environment || probe.environment || probe.source; }
    };

    static ProbeKey probeKey(const Scene& scene);
    void giveUp(const std::string& problem);
    void openHeader(const Scene& scene);
    void readWhole(const Scene& scene, const JobControl& job, WorkRecord& record);
    void openStreamed(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record);
    ProbeFile probeFile(const Scene& scene);
    MapLevels levels(KeptMap& kept, const std::optional<MapPlan>& plan, SceneProbe& probe, const MapDetail& detail, double exposure,
                     const JobControl& job, WorkRecord& record);
    void keepProbe(EnvironmentMap probe);
    bool isProbeItself(const MapPlan& plan, const SceneProbe& probe, const MapDetail& detail, double exposure) const;
    std::shared_ptr<const Image> brdfLookups(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record);
    /// What is to be kept of the plan's BRDF, not made yet.
    static KeptBrdf wantedBrdf(const Scene& scene, const BrdfPlan& plan);
    std::shared_ptr<const ViewStack> viewStack(const Scene& scene, const Plan& plan, SceneProbe& probe, const JobControl& job,
                                               WorkRecord& record);
    static void build(KeptSphereMap& map, const SphereMapChain& before, const Scene& scene, const JobControl& job);
    std::vector<SphereMapChain> sphereMaps(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record);

    std::optional<ProbeKey> m_key{};
    std::optional<ProbeFile> m_file{}; ///< open, not read yet
    std::string m_problem{};
    Opened m_now{};
    std::optional<Opened> m_before{}; ///< what the same file held before it changed, until it has been read again
    bool m_isKept = false;            ///< what is open now is that: the file cannot be read any more
    std::optional<KeptBrdf> m_brdf{};
    std::vector<KeptSphereMap> m_sphereMaps{};
    LivePicture m_diffusePicture{}, m_fleckPattern{}, m_normalMap{};
};

/// What stands in for a probe that is missing: a checkerboard of magenta and dark gray, that nobody takes for light.
EnvironmentMap placeholderProbe();

} // namespace mirrorball
