#include "command.h"

namespace mirrorball::cli {

void addCommands(CLI::App& program, int argc, const char* const* argv)
{
    addInfoCommand(program);
    addConvertCommand(program);
    addFilterCommand(program);
    addBrdfCommand(program);
    addRenderCommand(program);
    addExportCommand(program);
    addPaintCommand(program);
    addPresetsCommand(program);
    addReportCommand(program, argc, argv);
    addDoctorCommand(program);
    addBatchCommand(program);
    addRecipeCommand(program);
    refuseInfinities(program);
}

} // namespace mirrorball::cli
