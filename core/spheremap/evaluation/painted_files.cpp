#include "painted_files.h"

#include "core/image/map_file.h"
#include "core/image/opacity.h"
#include "core/image/picture_rows.h"
#include "core/spheremap/strokes/tile_set.h"

#include <algorithm>

namespace mirrorball {

namespace {

constexpr int bandsFrom = 2048;                 ///< texels an edge: less is made at once
constexpr int bandRows = 2 * TileSet::tileSize; ///< whole tiles of strokes, so that none is painted twice

/// Whether a map is made band by band: what moves the picture reads far beyond a band.
bool isMadeInBands(const std::filesystem::path& out, const SphereMapDocument& document, const PaintedOptions& options)
{
    const bool moves = std::any_of(document.layers.begin(), document.layers.end(),
                                   [](const Layer& layer) { return layer.visible && kindOf(layer.content).role == LayerRole::Warp; });
    return options.levels == PaintedLevels::One && options.size >= bandsFrom && writesRows(out) && !moves;
}

/// Rows of the picture with its borders, which repeat what is next to them.
class Bands {
public:
    Bands(const SphereMapDocument& document, const PaintedOptions& options, const JobControl& job)
        : m_document(document), m_options(options), m_job(job), m_size(options.size - 2 * options.border),
          m_assets(std::make_shared<SphereMapAssets>())
    {
    }

    /// The same picture, smaller.
    Image sample() const
    {
        const int size = std::min(m_size, 512);
        return evaluate(m_document, {.size = size, .levelSize = m_size, .assets = m_assets}, quiet());
    }

    Image rows(int firstRow, int count) const
    {
        const auto inMap = [this](int row) { return std::clamp(row - m_options.border, 0, m_size - 1); };
        const TexelRect region{0, inMap(firstRow), m_size, inMap(firstRow + count - 1) + 1};
        const Image made = evaluate(m_document, {.size = m_size, .region = region, .assets = m_assets}, quiet());
        if (m_job.progress)
            m_job.progress(static_cast<float>(firstRow + count) / static_cast<float>(m_options.size));
        if (m_options.border == 0)
            return made;
        Image picture(m_options.size, count, 4);
        for (int y = 0; y < count; ++y)
            for (int x = 0; x < picture.width; ++x)
                std::copy_n(made.texel(inMap(x), inMap(firstRow + y) - region.y0), 4, picture.texel(x, y));
        return picture;
    }

private:
    JobControl quiet() const { return {.stop = m_job.stop, .threads = m_job.threads}; }

    const SphereMapDocument& m_document;
    const PaintedOptions& m_options;
    const JobControl& m_job;
    int m_size;
    std::shared_ptr<SphereMapAssets> m_assets;
};

/// Thrown out of writing, so that the file does not appear: it needs an alpha channel.
struct NotOpaque {};

/// @return the channels. Whether the map is opaque everywhere is known in the end only; its sample nearly always tells.
int writeBands(const std::filesystem::path& file, const SphereMapDocument& document, const PaintedOptions& options,
               const WriteOptions& write, const JobControl& job)
{
    const Bands bands(document, options, job);
    const Image sample = bands.sample();
    const auto attempt = [&](int channels) {
        bool allOpaque = true;
        writeRows(file,
                  {.width = options.size,
                   .height = options.size,
                   .channels = channels,
                   .rows =
                       [&](int firstRow, int rows) {
                           Image band = bands.rows(firstRow, rows);
                           allOpaque = allOpaque && isOpaque(band);
                           if (channels == 3 && !allOpaque)
                               throw NotOpaque();
                           return channels == 3 ? withoutOpacity(band) : band;
                       },
                   .atATime = bandRows,
                   .sample = channels == 3 ? withoutOpacity(sample) : sample},
                  write);
        return allOpaque;
    };
    if (isOpaque(sample)) {
        try {
            attempt(3);
            return 3;
        } catch (const NotOpaque&) {
        }
    }
    if (!attempt(4))
        return 4;
    attempt(3);
    return 3;
}

} // namespace

PaintedFiles writePainted(const std::filesystem::path& out, const SphereMapDocument& document, const PaintedOptions& options,
                          SampleType samples, const JobControl& job)
{
    const WriteOptions write = paintedFileOptions(document, samples);
    PaintedFiles made;
    if (isMadeInBands(out, document, options)) {
        validate(options);
        validate(document);
        made.files = mapFiles(out, {{Parameterization::Sphere, options.size, 0}});
        timedStage(made.stages, "evaluate and write map", [&] {
            made.levels = {{options.size, writeBands(made.files.front(), document, options, write, job)}};
        });
        return made;
    }
    const std::vector<Image> levels = timedStage(made.stages, "evaluate", [&] { return paintedPictures(document, options, job); });
    made.files = timedStage(made.stages, "write map", [&] { return writePictures(out, levels, write); });
    for (const Image& level : levels)
        made.levels.push_back({level.width, level.channels});
    return made;
}

} // namespace mirrorball
