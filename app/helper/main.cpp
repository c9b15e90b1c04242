#include "confinement.h"
#include "connection.h"
#include "mesh_import.h"
#include "picture_service.h"
#include "png_decoder.h"
#include "zstd_service.h"

#include "core/base/error.h"
#include "core/image/openimageio_library.h"

#include <assimp/version.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>
#include <string>

#include <link.h>

/// mirrorball-helper: reads files of other formats for the program that started it, which it talks with through a socket
/// (core/base/helper_protocol.h). Nobody starts it by hand.
namespace {

using namespace mirrorball;
using namespace mirrorball::helper;

/// What a request does, its errors turned into answers.
template <class Work>
void answering(Connection& connection, const Work& work)
{
    try {
        work();
    } catch (const InvalidArgument& error) {
        connection.send(Answer::Refused, std::string_view(error.what()).substr(0, 2000));
    } catch (const WorkError& error) {
        connection.send(Answer::Failed, std::string_view(error.what()).substr(0, 2000));
    } catch (...) { // std::bad_alloc, and what else the libraries let out: the program tells it from the way this one ends
        std::abort();
    }
}

[[noreturn]] void serve(bool pictures)
{
    Connection connection;
    std::optional<PictureService> reader;
    ZstdService zstd;
    std::string reason; // why nothing can be read
    try {
        if (pictures)
            reader.emplace();
        confine(channel);
    } catch (const WorkError& error) {
        reason = error.what();
    }
    for (;;) {
        const Received request = connection.receive();
        allow(request.head.milliseconds, request.head.memory);
        answering(connection, [&] {
            if (!reason.empty())
                throw WorkError(reason);
            if (reader)
                reader->serve(request, connection);
            else if (static_cast<Request>(request.head.kind) == Request::DecodePng)
                servePng(request, connection);
            else if (static_cast<Request>(request.head.kind) == Request::UnpackZstd)
                zstd.serve(request, connection);
            else
                serveMesh(request, connection);
        });
    }
}

/// The file of OpenImageIO, whose name ends in its version, or why it cannot be loaded.
std::string openImageIoName()
{
    try {
        openimageio::module();
    } catch (const WorkError& error) {
        return error.what();
    }
    std::string name = "OpenImageIO";
    ::dl_iterate_phdr(
        [](dl_phdr_info* library, size_t, void* found) {
            const std::string file = std::filesystem::path(library->dlpi_name).filename().string();
            if (file.starts_with("libOpenImageIO.so"))
                *static_cast<std::string*>(found) = file;
            return 0;
        },
        &name);
    return name;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc == 2 && std::strcmp(argv[1], "versions") == 0) {
        std::printf("Assimp %u.%u.%u, %s\n", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch(), openImageIoName().c_str());
        return 0;
    }
    if (argc != 3 || argv[2] != std::to_string(helper::version))
        return 126;
    limitProcess();
    serve(std::strcmp(argv[1], "pictures") == 0);
}
