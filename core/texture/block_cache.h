#pragma once

// Compressed levels that are kept between runs, as DDS files in a directory.

#include "core/base/result.h"
#include "core/image/block_image.h"
#include "core/image/image.h"
#include "core/s3tc/encode_quality.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texplorer {

/// A directory of compressed mip chains, each under a name that is a hash of all that its blocks depend on:
/// the pixels of every level (and with them file, flip, mip filter and whatever else went into them), the
/// format, the quality and the encoder's version. So an entry never is out of date.
///
/// A value that holds nothing open: several threads and programs may share a directory. Entries are DDS files
/// whose rows are in OpenGL's order, so other viewers show them upside down; the checksum of all their bytes
/// lies where other readers look at nothing, in dwReserved1.
class BlockCache {
public:
    static constexpr std::uintmax_t defaultMaxBytes = std::uintmax_t{512} << 20;

    /// Keeps nothing and finds nothing.
    BlockCache() = default;
    /// The directory is made when something is first kept; a relative one belongs to the current directory.
    /// Its entries never take more than `maxBytes` together: those used longest ago make room.
    explicit BlockCache(std::filesystem::path directory, std::uintmax_t maxBytes = defaultMaxBytes);

    /// $XDG_CACHE_HOME/texplorer/blocks, else $HOME/.cache/texplorer/blocks; where neither variable holds an
    /// absolute path, one that keeps nothing.
    [[nodiscard]] static BlockCache ofUser();

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

    /// The file that holds or would hold these levels; empty where nothing is kept.
    [[nodiscard]] std::filesystem::path fileFor(const MipChain& source, BlockFormat format,
                                                EncodeQuality quality) const;

    /// The blocks that a file holds for this source, or nothing: no such file, a link, or one that is
    /// damaged, be it by a bit, foreign or of other sizes. Using an entry makes it the youngest.
    [[nodiscard]] std::optional<std::vector<BlockImage>>
    find(const std::filesystem::path& file, const MipChain& source, BlockFormat format) const;

    /// Writes an entry atomically, in place of whatever has its name (a link is not followed), and makes room
    /// for it. Errors: there is no directory, it can't be made or written, it isn't private
    /// (core/base/private_directory.h), the levels alone exceed the bound.
    [[nodiscard]] Result<void> keep(const std::filesystem::path& file, std::vector<BlockImage> levels) const;

private:
    std::filesystem::path directory_;
    std::uintmax_t maxBytes_ = defaultMaxBytes;
};

} // namespace texplorer
