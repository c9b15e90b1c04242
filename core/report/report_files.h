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
/// parameterizations; the extreme cases; the table of kernel sizes; figure 12, a row a distance.
std::string measurementsCsv(const Report& report);
std::string growthCsv(const Report& report);
std::string parameterizationsCsv(const Report& report);
std::string stabilityCsv(const Report& report);
std::string shadingCsv(const Report& report);
std::string kernelsCsv(const KernelTable& table);
std::string distortionCsv(const std::vector<DistortionCurve>& curves);

/// That a report can be written into a folder that exists or can be made: asked before the minutes of measuring.
/// @throws InvalidArgument when the way there is a file or is write-protected
void checkReportFolder(const std::filesystem::path& folder);

/// Writes report.html and report.json into a folder, which is made when missing, and of the tables and pictures those that the report
/// holds: measurements.csv, growth.csv, parameterizations.csv, stability.csv, shading.csv, kernels.csv, distortion.csv,
/// comparison_LABEL.png. Each file appears whole or not at all.
/// @return the files, the page first
/// @throws WorkError
std::vector<std::filesystem::path> writeReport(const Report& report, const std::filesystem::path& folder);

} // namespace mirrorball
