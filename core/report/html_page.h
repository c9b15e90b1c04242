#pragma once

#include "report.h"

#include <string>
#include <string_view>

namespace mirrorball {

/// What the page is put together from: files of resources/report and the plotting library, compiled in.
struct PageParts {
    std::string_view html; ///< with @STYLE@ and so on where the others go
    std::string_view style;
    std::string_view script;
    std::string_view chartLicense;
    std::string_view chartLibrary;
};
PageParts pageParts();

/// The report as one self-contained page: figures, pictures, plots and the library that draws them are in it; its security policy forbids
/// every request. `json` is the report with its pictures (report_files.h).
std::string htmlPage(const std::string& json);

} // namespace mirrorball
