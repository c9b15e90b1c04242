#include "picture_service.h"

#include "core/base/error.h"
#include "core/base/wire.h"
#include "core/image/openimageio_library.h"
#include "core/image/picture_wire.h"

namespace mirrorball::helper {

PictureService::PictureService() : m_module(openimageio::module()) {}

void PictureService::serve(const Received& request, Connection& connection)
{
    switch (static_cast<Request>(request.head.kind)) {
    case Request::OpenPicture:
        return open(request, connection);
    case Request::ReadRows:
        return readRows(request, connection);
    case Request::ClosePicture:
        return m_reader.reset();
    case Request::ReadMesh:
    case Request::DecodePng:
    case Request::UnpackZstd:
        break;
    }
    throw InvalidArgument("no such request");
}

void PictureService::open(const Received& request, Connection& connection)
{
    std::string path, format;
    WireReader reader(request.bytes);
    reader >> path >> format;
    openimageio::visitRequest(m_wanted, [&](auto&... members) { (reader >> ... >> members); });
    m_reader.reset(); // before the next one takes memory
    m_reader = m_module.open(path, format, m_wanted);
    connection.send(Answer::Result, openimageio::toWire(m_reader->info()));
}

void PictureService::readRows(const Received& request, Connection& connection)
{
    int first = 0, rows = 0;
    WireReader(request.bytes) >> first >> rows;
    if (!m_reader || first < 0 || rows < 1 || rows > m_reader->info().height - first)
        throw InvalidArgument("no such rows");
    const ImageFileInfo& info = m_reader->info();
    std::vector<float> samples(static_cast<size_t>(rows) * static_cast<size_t>(info.width) *
                               static_cast<size_t>(texelFloats(m_wanted.channels)));
    m_reader->readRows(first, rows, samples.data());
    connection.send(Answer::Result, samples.data(), samples.size() * sizeof(float));
}

} // namespace mirrorball::helper
