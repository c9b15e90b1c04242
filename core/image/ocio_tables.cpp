#include "ocio_tables.h"

#include "core/base/file_log.h"

namespace mirrorball {

void noteTables(const OCIO_NAMESPACE::Processor& processor)
{
    const auto known = processor.getProcessorMetadata();
    for (int i = 0; i < known->getNumFiles(); ++i)
        noteRead(known->getFile(i));
}

} // namespace mirrorball
