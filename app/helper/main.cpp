#include "confinement.h"
#include "connection.h"
#include "mesh_import.h"
#include "picture_service.h"

#include "core/base/error.h"

#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
#include <string>

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
            else
                serveMesh(request, connection);
        });
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3 || argv[2] != std::to_string(helper::version))
        return 126;
    limitProcess();
    serve(std::strcmp(argv[1], "pictures") == 0);
}
