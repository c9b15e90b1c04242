#pragma once

#include "core/base/opened_file.h"

#include <ImfIO.h>

#include <cstdint>
#include <string>

namespace mirrorball::exr {

/// An opened file as OpenEXR reads one, its attributes looked at before (exr_attributes.h). One thread at a time, as OpenEXR locks it.
class FileStream final : public Imf::IStream {
public:
    /// @throws FileError as checkAttributes()
    explicit FileStream(OpenedFile file);

    const OpenedFile& file() const { return m_file; }

    bool read(char bytes[], int count) override;
    std::uint64_t tellg() override { return m_file.position(); }
    void seekg(std::uint64_t position) override { m_file.seek(position); }

private:
    OpenedFile m_file;
};

} // namespace mirrorball::exr
