#pragma once

#include <string>

#include "cli/command.h"
#include "segmentation/sketch.h"

// What the tool segment does, by the options it is asked for; each declares its own and returns the exit
// code.
namespace partwise::segment {

/// Cuts a mesh into the parts of a sketch, or takes the parts over from another segmentation.
int cut(cli::Command& command, int argc, char** argv);

/// --check: whether segmentations match.
int check(cli::Command& command, int argc, char** argv);

/// --auto: a sketch to start from.
int suggest(cli::Command& command, int argc, char** argv);

void write_sketch(const cli::Command& command, const std::string& path, const Sketch& sketch,
                  const std::string& comment);

}  // namespace partwise::segment
