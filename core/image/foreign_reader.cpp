#include "foreign_reader.h"

#include "input_checks.h"
#include "picture_wire.h"

#include "core/base/helper_process.h"

#include <algorithm>

namespace mirrorball::openimageio {
namespace {

/// A picture is refused that claims more texels than this and than its bytes can tell of: 16-bit .png and .webp files of a few hundred
/// bytes can be blank and 2^28 texels large, and nobody lights with those.
constexpr std::int64_t fewTexels = std::int64_t{1} << 24;
constexpr std::int64_t texelsPerByte = 128;

HelperLimits limitsFor(std::uintmax_t fileBytes)
{
    constexpr std::uintmax_t mib = std::uintmax_t{1} << 20;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    constexpr double slower = 20.0;
#else
    constexpr double slower = 1.0;
#endif
    return {.seconds = slower * std::min(600.0, 1.2 + static_cast<double>(fileBytes) / static_cast<double>(mib)),
            .memoryBytes = std::min(6144 * mib, 384 * mib + 64 * fileBytes)};
}

class ForeignReader final : public RawReader {
public:
    ForeignReader(const std::filesystem::path& path, const std::string& format, int level) : m_helper(HelperWork::Pictures)
    {
        std::error_code error;
        const std::uintmax_t bytes = std::filesystem::file_size(path, error);
        if (error)
            throw FileError(path.string(), "cannot be read: " + error.message() + "; check its permissions");
        WireWriter request;
        request << std::string_view(path.native()) << std::string_view(format) << level;
        const HelperLimits limits = limitsFor(bytes);
        m_picture.info.path = path;
        m_picture.info.format = format;
        const bool isWhole =
            guarded([&] { return fromWire(m_helper.ask(helper::Request::OpenPicture, std::move(request).bytes(), &limits), m_picture); });
        const ImageFileInfo& info = m_picture.info;
        if (!isWhole || info.channels < 1 || info.channels > 1024 || info.levels < 1)
            throw FileError(path.string(), "the picture breaks its reader; export or download it again");
        checkImageSize(path.string(), info.width, info.height);
        const std::int64_t texels = std::int64_t{info.width} * info.height;
        if (texels > std::max(fewTexels, texelsPerByte * static_cast<std::int64_t>(bytes)))
            throw FileError(path.string(), "its header claims " + std::to_string(info.width) + " x " + std::to_string(info.height) +
                                               " texels in a file of " + std::to_string(bytes) +
                                               " bytes; it is damaged or blank, scale it down or export it again");
    }
    ~ForeignReader() override { m_helper.tell(helper::Request::ClosePicture); }

    const ImageFileInfo& info() const override { return m_picture.info; }
    bool isSrgb() const override { return m_picture.isSrgb; }

    void readRows(int firstRow, int rows, float* samples) override
    {
        const size_t count = static_cast<size_t>(rows) * static_cast<size_t>(info().width) * static_cast<size_t>(info().channels);
        WireWriter request;
        request << firstRow << rows;
        guarded([&] {
            m_helper.askInto(helper::Request::ReadRows, std::move(request).bytes(), samples, count * sizeof(float));
            return true;
        });
    }

private:
    template <class Action>
    bool guarded(const Action& action) const
    {
        try {
            return action();
        } catch (const InvalidArgument& refused) { // the wire tells no kinds of refusals, and what is refused here is the file
            std::string_view message = refused.what();
            const std::string start = shownPath(info().path.string()) + ": ";
            message.remove_prefix(message.starts_with(start) ? start.size() : 0);
            throw FileError(info().path.string(), std::string(message));
        } catch (const HelperEnded& ended) {
            throw FileError(info().path.string(), "the reader of " + info().format + " pictures gave up on it, because " + ended.what() +
                                                      "; the file is damaged or does harm, export or download it again");
        }
    }

    Helper m_helper;
    OpenedPicture m_picture{};
};

} // namespace

std::unique_ptr<RawReader> openForeign(const std::filesystem::path& path, const std::string& format, int level)
{
    return std::make_unique<ForeignReader>(path, format, level);
}

} // namespace mirrorball::openimageio
