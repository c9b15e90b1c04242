#pragma once

#include "report.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mirrorball {

enum class Pictures { Embedded, LeftOut };

/// The whole report as JSON; pictures as data URIs. Figures that are not finite are null.
std::string reportJson(const Report& report, Pictures pictures);

/// Tables as CSV (RFC 4180, a header first, "." for decimals): every measurement of every probe and lobe; the growth of cost; the
/// parameterizations; the extreme cases.
std::string measurementsCsv(const Report& report);
std::string growthCsv(const Report& report);
std::string parameterizationsCsv(const Report& report);
std::string stabilityCsv(const Report& report);
std::string shadingCsv(const Report& report);

/// That a report can be written into a folder that exists or can be made: asked before the minutes of measuring.
/// @throws InvalidArgument when the way there is a file or is write-protected
void checkReportFolder(const std::filesystem::path& folder);

/// Writes report.html, report.json and measurements.csv into a folder, which is made when missing, and growth.csv, parameterizations.csv
/// and stability.csv and shading.csv where there is something in them. Each file appears whole or not at all.
/// @return the files, the page first
/// @throws WorkError
std::vector<std::filesystem::path> writeReport(const Report& report, const std::filesystem::path& folder);

} // namespace mirrorball
