#include "png_decoder.h"

#include "core/base/error.h"
#include "core/base/wire.h"
#include "core/image/container/packed_texel.h"
#include "core/image/container/png_failure.h"
#include "core/image/input_checks.h"

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball::helper {
namespace {

using png::Failure;

void take(png_structp png, png_bytep bytes, png_size_t count)
{
    auto* rest = static_cast<std::string_view*>(png_get_io_ptr(png));
    if (rest->size() < count)
        png_error(png, "it ends early");
    std::memcpy(bytes, rest->data(), count);
    rest->remove_prefix(count);
}

/// The state of a reading, owned outside of the functions that longjmp leaves.
struct Reading {
    png_structp png = nullptr;
    png_infop info = nullptr;
    Failure failure{};
    std::string_view rest{};

    Reading() = default;
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
    ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }
};

bool readHeader(Reading& reading)
{
    if (setjmp(png_jmpbuf(reading.png)) != 0)
        return false;
    png_read_info(reading.png, reading.info);
    return true;
}

/// Everything becomes 8-bit RGBA, in one pass over the rows.
bool readRows(Reading& reading, png_bytep* rows, size_t rowBytes)
{
    if (setjmp(png_jmpbuf(reading.png)) != 0)
        return false;
    png_set_expand(reading.png);
    png_set_scale_16(reading.png);
    png_set_gray_to_rgb(reading.png);
    png_set_add_alpha(reading.png, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(reading.png);
    png_read_update_info(reading.png, reading.info);
    if (png_get_rowbytes(reading.png, reading.info) != rowBytes)
        png_error(reading.png, "its rows have an unexpected length");
    png_read_image(reading.png, rows);
    return true;
}

InvalidArgument damaged(const Reading& reading)
{
    return InvalidArgument("its PNG picture is damaged: " + oneLine(reading.failure.message.data()) + "; copy or download it again");
}

} // namespace

void servePng(const Received& request, Connection& connection)
{
    long long largestTexels = 0;
    std::string bytes;
    WireReader(request.bytes) >> largestTexels >> bytes;
    Reading reading;
    reading.rest = bytes;
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading.failure, png::onError, png::onWarning);
    reading.info = reading.png != nullptr ? png_create_info_struct(reading.png) : nullptr;
    if (reading.info == nullptr)
        throw WorkError("libpng cannot be started; there may be too little memory");
    png_set_read_fn(reading.png, &reading.rest, take);
    // Text and profiles, which nobody asks for, unpack to eight megabytes from eight kilobytes, chunk after chunk.
    png_set_keep_unknown_chunks(reading.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    if (!readHeader(reading))
        throw damaged(reading);
    const long long width = png_get_image_width(reading.png, reading.info), height = png_get_image_height(reading.png, reading.info);
    if (width < 1 || height < 1 || width > largestTexels || height > largestTexels || width * height > largestTexels)
        throw InvalidArgument("its PNG picture claims " + std::to_string(width) + " x " + std::to_string(height) +
                              " texels, more than belong there; copy or download it again");
    std::vector<Rgba8> texels(static_cast<size_t>(width * height));
    std::vector<png_bytep> rows;
    for (long long y = 0; y < height; ++y)
        rows.push_back(texels[static_cast<size_t>(y * width)].data());
    if (!readRows(reading, rows.data(), sizeof(Rgba8) * static_cast<size_t>(width)))
        throw damaged(reading);
    WireWriter answer;
    answer << static_cast<int>(width) << static_cast<int>(height) << texels;
    connection.send(Answer::Result, std::move(answer).bytes());
}

} // namespace mirrorball::helper
