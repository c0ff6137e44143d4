#pragma once

// Caches compressed levels between runs, as DDS files in a directory.

#include "texplorer/base/result.h"
#include "texplorer/image/block_image.h"
#include "texplorer/image/image.h"
#include "texplorer/s3tc/encode_quality.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texplorer {

/// A directory of compressed mip chains. Their names are hashes of everything that the blocks depend on: the
/// pixels of every level (and with them file, flip, mip filter and all else), the format, the quality and
/// the encoder's version. So entries are never outdated.
///
/// A value type that keeps no files open: several threads and programs can share a directory. Entries are DDS
/// files with rows in OpenGL's order, so other viewers show them upside down; the checksum of all their bytes
/// is in dwReserved1, which other readers ignore.
class BlockCache {
public:
    static constexpr std::uintmax_t defaultMaxBytes = std::uintmax_t{512} << 20;

    /// A cache that stores and finds nothing.
    BlockCache() = default;
    /// The directory is created when the first entry is stored; a relative path refers to the current
    /// directory. The entries never exceed `maxBytes` in total: the least recently used ones are removed.
    explicit BlockCache(std::filesystem::path directory, std::uintmax_t maxBytes = defaultMaxBytes);

    /// $XDG_CACHE_HOME/texplorer/blocks, else $HOME/.cache/texplorer/blocks; if neither variable is an
    /// absolute path, a cache that stores nothing.
    [[nodiscard]] static BlockCache ofUser();

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

    /// The file of these levels, existing or not; empty if nothing is stored.
    [[nodiscard]] std::filesystem::path fileFor(const MipChain& source, BlockFormat format,
                                                EncodeQuality quality) const;

    /// Reads the blocks for this source from a file; empty if the file does not exist, is a link, or is
    /// damaged (even by a bit), foreign or of other sizes. Marks the entry as recently used.
    [[nodiscard]] std::optional<std::vector<BlockImage>>
    find(const std::filesystem::path& file, const MipChain& source, BlockFormat format) const;

    /// Writes an entry atomically, replacing any file of its name (links are not followed), and removes
    /// others if needed. Errors: there is no directory; it cannot be created or written; it is not private
    /// (texplorer/files/private_directory.h); the levels alone exceed the limit.
    [[nodiscard]] Result<void> keep(const std::filesystem::path& file, std::vector<BlockImage> levels) const;

private:
    std::filesystem::path directory_;
    std::uintmax_t maxBytes_ = defaultMaxBytes;
};

} // namespace texplorer
