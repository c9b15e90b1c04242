#include "exr_stream.h"

#include "exr_attributes.h"

#include <Iex.h>

#include <utility>

namespace mirrorball::exr {

FileStream::FileStream(OpenedFile file) : IStream(file.path().c_str()), m_file(std::move(file))
{
    checkAttributes(m_file);
    m_file.seek(0);
}

bool FileStream::read(char bytes[], int count)
{
    if (m_file.read(bytes, static_cast<size_t>(count)) != static_cast<size_t>(count))
        throw Iex::InputExc("Unexpected end of file.");
    return m_file.position() < m_file.size();
}

} // namespace mirrorball::exr
