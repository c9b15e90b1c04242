#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace mirrorball {

/// Says (noteRead) which files of tables a processor was made of: a configuration only names them, and results follow from their content.
void noteTables(const OCIO_NAMESPACE::Processor& processor);

} // namespace mirrorball
