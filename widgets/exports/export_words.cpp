#include "export_words.h"

#include "export_dialog.h"
#include "widgets/controls/text.h"

#include <algorithm>

namespace mirrorball::studio {

QString kindText(ExportKind kind)
{
    switch (kind) {
    case ExportKind::Source:
        return ExportDialog::tr("Environment as it is");
    case ExportKind::Specular:
        return ExportDialog::tr("Specular, the material's lobe");
    case ExportKind::Diffuse:
        return ExportDialog::tr("Diffuse irradiance");
    case ExportKind::Chain:
        return ExportDialog::tr("Roughness chain, ggx 0 to 1");
    case ExportKind::Painted:
        return ExportDialog::tr("Sphere map, as it is painted");
    }
    return {};
}

QString filesText(size_t count) { return count == 1 ? ExportDialog::tr("1 file") : ExportDialog::tr("%1 files").arg(count); }

QString mapText(const ExportEstimate& estimate)
{
    return ExportDialog::tr("%1, %2: about %3; %4 of texels before compression")
        .arg(filesText(estimate.files.size()),
             estimate.levels == 1 ? ExportDialog::tr("one level") : ExportDialog::tr("%1 levels").arg(estimate.levels),
             toQString(byteText(estimate.fileBytes)), toQString(byteText(estimate.texelBytes)));
}

QString totalText(const std::vector<ExportEstimate>& estimates, const std::vector<std::string>& chosen, double sharedSeconds)
{
    std::int64_t bytes = 0;
    double seconds = 0.0;
    bool readsProbe = false;
    size_t files = 0;
    for (const std::string& name : chosen) {
        const auto found = std::find_if(estimates.begin(), estimates.end(), [&](const ExportEstimate& e) { return e.name == name; });
        if (found == estimates.end())
            continue;
        bytes += found->fileBytes;
        seconds += found->seconds;
        readsProbe |= !found->isPainted;
        files += found->files.size();
    }
    if (readsProbe)
        seconds += sharedSeconds;
    if (files == 0)
        return estimates.empty() ? ExportDialog::tr("No estimate yet.") : ExportDialog::tr("No map is checked.");
    return ExportDialog::tr("%1, about %2 in all%3")
        .arg(filesText(files), toQString(byteText(bytes)),
             seconds == 0.0  ? QString()
             : seconds < 0.1 ? ExportDialog::tr("; computed in less than 0.1 s")
                             : ExportDialog::tr("; computed in about %1 s").arg(seconds, 0, 'f', 1));
}

} // namespace mirrorball::studio
