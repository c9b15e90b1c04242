#pragma once

#include "connection.h"

#include "core/image/openimageio_module.h"

#include <memory>

namespace mirrorball::helper {

/// Reads pictures through OpenImageIO, one at a time.
class PictureService {
public:
    /// Loads OpenImageIO. @throws WorkError when it is not installed
    PictureService();
    /// @throws InvalidArgument for a picture that cannot be read
    void serve(const Received& request, Connection& connection);

private:
    void open(const Received& request, Connection& connection);
    void readRows(const Received& request, Connection& connection);

    const openimageio::Module& m_module;
    std::unique_ptr<openimageio::RawReader> m_reader{};
};

} // namespace mirrorball::helper
