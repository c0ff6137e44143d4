#pragma once

namespace texplorer {

/// What a writer may be told; each takes what concerns it.
struct WriteOptions {
    bool small = false;          ///< PNG: smaller rather than faster
    bool runLengthCoded = false; ///< TGA
};

} // namespace texplorer
