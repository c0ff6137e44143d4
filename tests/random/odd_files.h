#pragma once

// Image files that no artist would make: tiny, of odd sizes, cubes, volumes, compressed, without some levels,
// cut, changed.

#include "texplorer/base/bytes.h"

#include <string>
#include <vector>

namespace texplorer::random {

struct OddFile {
    std::string name; ///< "dds-3.dds", and "dds-3-cut.dds" for what is left of it
    Bytes bytes;
};

/// Of every format, whole ones and damaged ones; the same ones each time.
[[nodiscard]] std::vector<OddFile> oddFiles();

/// Their names, and some under which there is nothing.
[[nodiscard]] std::vector<std::string> namesOf(const std::vector<OddFile>& files);

} // namespace texplorer::random
