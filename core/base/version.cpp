#include "version.h"

namespace mirrorball {

std::string_view version() { return MIRRORBALL_VERSION; }

} // namespace mirrorball
