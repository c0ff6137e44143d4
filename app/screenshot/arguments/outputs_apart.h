#pragma once

#include "texplorer/base/result.h"

#include <span>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// An option and the file that it writes; an empty one names none.
struct NamedOutput {
    const char* option;
    std::string path;
    bool isFolder = false; ///< whatever lies in it is replaced or removed
};

/// An output for each of an option's files.
[[nodiscard]] std::vector<NamedOutput> outputsOf(const char* option, std::span<const std::string> files);

/// The files that lie in a folder, for who reads all of them.
[[nodiscard]] std::vector<std::string> filesIn(const std::string& folder);

/// No output may take the place of what is read, under whatever name: links, relative names, and "-" where
/// standard input or output is a file. `inputs` are files, "-" is standard input. The error names the option.
[[nodiscard]] Result<void> checkNotRead(std::span<const NamedOutput> outputs,
                                        std::span<const std::string> inputs);

/// What every command asks before it writes: that, and that no output takes the place of another one.
[[nodiscard]] Result<void> checkOutputsApart(std::span<const NamedOutput> outputs,
                                             std::span<const std::string> inputs);

} // namespace texplorer::screenshot
