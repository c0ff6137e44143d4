#pragma once

// texshot's commands, a file each. main.cpp has the table of them.

#include "app/command_line/command_line.h"
#include "app/screenshot/output/answer.h"

namespace texplorer::screenshot {

void addShot(CommandLine& line);
void addAnimate(CommandLine& line);
void addSweep(CommandLine& line);
void addProbe(CommandLine& line);
void addCheck(CommandLine& line);
void addCompare(CommandLine& line);
void addCommands(CommandLine& line);
void addEmit(CommandLine& line);
void addParams(CommandLine& line);
void addPresets(CommandLine& line);
void addScene(CommandLine& line);
void addValidate(CommandLine& line);
void addDiff(CommandLine& line);
void addDrivers(CommandLine& line);
void addLessons(CommandLine& line);
void addDecode(CommandLine& line);
void addInfo(CommandLine& line);
void addFlip(CommandLine& line);
void addCompress(CommandLine& line);
void addConform(CommandLine& line);
void addConvert(CommandLine& line);
void addCost(CommandLine& line);
void addSchema(CommandLine& line);
void addTexture(CommandLine& line);
void addTest(CommandLine& line);
void addMerge(CommandLine& line);

/// What --help and the manual say of the commands declared so far, next to their options: examples, formats.
void addHelpSections(CommandLine& line);

} // namespace texplorer::screenshot
