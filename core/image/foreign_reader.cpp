#include "foreign_reader.h"

#include "input_checks.h"
#include "picture_wire.h"

#include "core/base/helper_process.h"

#include <algorithm>

namespace mirrorball::openimageio {
namespace {

HelperLimits limitsFor(std::uintmax_t fileBytes)
{
    constexpr std::uintmax_t mib = std::uintmax_t{1} << 20;
    return {.seconds = helperSlowdown * std::min(600.0, 1.2 + static_cast<double>(fileBytes) / static_cast<double>(mib)),
            .memoryBytes = std::min(6144 * mib, 384 * mib + 64 * fileBytes)};
}

class ForeignReader final : public ImageReader {
public:
    ForeignReader(const std::filesystem::path& path, const std::string& format, const RawRequest& wanted)
        : m_helper(HelperWork::Pictures), m_floats(static_cast<size_t>(texelFloats(wanted.channels)))
    {
        std::error_code error;
        const std::uintmax_t bytes = std::filesystem::file_size(path, error);
        if (error)
            throw FileError(path.string(), "cannot be read: " + error.message() + "; check its permissions");
        WireWriter request;
        request << std::string_view(path.native()) << std::string_view(format);
        visitRequest(wanted, [&](const auto&... members) { (request << ... << members); });
        const HelperLimits limits = limitsFor(bytes);
        m_info.path = path;
        m_info.format = format;
        const bool isWhole =
            guarded([&] { return fromWire(m_helper.ask(helper::Request::OpenPicture, std::move(request).bytes(), &limits), m_info); });
        const ImageFileInfo& info = m_info;
        const bool isSane = info.channels >= 1 && info.channels <= 1024 && info.levels >= 1 && info.parts >= 1 && info.orientation >= 1 &&
                            info.orientation <= 8;
        if (!isWhole || !isSane)
            throw FileError(path.string(), "the picture breaks its reader; export or download it again");
        checkImageSize(path.string(), info.width, info.height);
        checkTexelsHeld(path.string(), info.width, info.height, bytes, 128);
    }
    ~ForeignReader() override { m_helper.tell(helper::Request::ClosePicture); }

    const ImageFileInfo& info() const override { return m_info; }

    void readRows(int firstRow, int rows, float* texels) override
    {
        const size_t count = static_cast<size_t>(rows) * static_cast<size_t>(info().width) * m_floats;
        WireWriter request;
        request << firstRow << rows;
        guarded([&] {
            m_helper.askInto(helper::Request::ReadRows, std::move(request).bytes(), texels, count * sizeof(float));
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
    size_t m_floats; ///< a texel
    ImageFileInfo m_info{};
};

} // namespace

std::unique_ptr<ImageReader> openForeign(const std::filesystem::path& path, const std::string& format, const RawRequest& request)
{
    return std::make_unique<ForeignReader>(path, format, request);
}

} // namespace mirrorball::openimageio
