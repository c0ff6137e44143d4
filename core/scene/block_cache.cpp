#include "core/scene/block_cache.h"

#include "core/base/file_io.h"
#include "core/codec/dds.h"
#include "core/s3tc/encode.h"

#define XXH_INLINE_ALL // the header is all of it: no library to link
#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <new>
#include <system_error>
#include <xxhash.h>

namespace texplorer {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t hashDigits = 32;
constexpr std::size_t maxHeaderBytes = 148; // of a DDS file with the DX10 header

std::string hexadecimal(XXH128_hash_t hash) {
    constexpr char digits[] = "0123456789abcdef";
    XXH128_canonical_t bytes;
    XXH128_canonicalFromHash(&bytes, hash);
    std::string text;
    for (const unsigned char byte : bytes.digest) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

std::string keyOf(const MipChain& source, BlockFormat format, EncodeQuality quality) {
    const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), XXH3_freeState);
    if (!state)
        throw std::bad_alloc();
    XXH3_128bits_reset(state.get());
    const auto add = [&](auto... numbers) {
        const std::array all{static_cast<std::uint32_t>(numbers)...};
        XXH3_128bits_update(state.get(), all.data(), sizeof all);
    };
    add(encoderVersion, format, quality, source.size());
    for (const Image& level : source) {
        add(level.format, level.width, level.height, level.depth);
        XXH3_128bits_update(state.get(), level.pixels.data(), level.pixels.size());
    }
    return hexadecimal(XXH3_128bits_digest(state.get()));
}

std::size_t blockBytes(const Image& level, BlockFormat format) {
    return (static_cast<std::size_t>(level.width) + 3) / 4 *
           ((static_cast<std::size_t>(level.height) + 3) / 4) * bytesPerBlock(format);
}

/// Entries, and drafts that a program left behind which was killed while it wrote one.
bool isOurs(const fs::directory_entry& file) {
    std::error_code error;
    if (!fs::is_regular_file(file.symlink_status(error)))
        return false;
    const std::string name = file.path().filename().string();
    if (name.starts_with(".texplorer-") && name.ends_with(".tmp"))
        return true;
    return name.size() == hashDigits + 4 && name.ends_with(".dds") &&
           name.find_first_not_of("0123456789abcdef") == hashDigits;
}

/// Removes the oldest files until at most `maxBytes` are left beside `replaced`, which is about to be
/// written.
void makeRoom(const fs::path& directory, std::uintmax_t maxBytes, const fs::path& replaced) {
    struct Entry {
        fs::path path;
        std::uintmax_t bytes;
        fs::file_time_type used;
    };
    std::vector<Entry> entries;
    std::uintmax_t sum = 0;
    std::error_code error; // a file that another program has just removed takes no room either
    for (fs::directory_iterator at(directory, error), end; !error && at != end; at.increment(error)) {
        std::error_code gone;
        if (!isOurs(*at) || at->path().filename() == replaced.filename())
            continue;
        const std::uintmax_t bytes = at->file_size(gone);
        const fs::file_time_type used = gone ? fs::file_time_type() : at->last_write_time(gone);
        if (gone)
            continue;
        sum += bytes;
        entries.push_back({at->path(), bytes, used});
    }
    std::ranges::sort(entries, {}, &Entry::used);
    for (const Entry& entry : entries) {
        if (sum <= maxBytes)
            return;
        if (std::error_code kept; fs::remove(entry.path, kept))
            sum -= entry.bytes;
    }
}

/// An absolute path, as the XDG Base Directory Specification wants it, or nothing.
fs::path directoryIn(const char* variable) {
    const char* value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe): nobody changes it
    fs::path path = value == nullptr ? "" : value;
    return path.is_absolute() ? path : fs::path();
}

} // namespace

BlockCache::BlockCache(fs::path directory, std::uintmax_t maxBytes)
    : directory_(std::move(directory))
    , maxBytes_(maxBytes) {}

BlockCache BlockCache::ofUser() {
    if (const fs::path caches = directoryIn("XDG_CACHE_HOME"); !caches.empty())
        return BlockCache(caches / "texplorer" / "blocks");
    if (const fs::path home = directoryIn("HOME"); !home.empty())
        return BlockCache(home / ".cache" / "texplorer" / "blocks");
    return {};
}

fs::path BlockCache::fileFor(const MipChain& source, BlockFormat format, EncodeQuality quality) const {
    return directory_.empty() ? fs::path() : directory_ / (keyOf(source, format, quality) + ".dds");
}

std::optional<std::vector<BlockImage>> BlockCache::find(const fs::path& file, const MipChain& source,
                                                        BlockFormat format) const {
    if (file.empty() || source.empty())
        return std::nullopt;
    std::size_t wanted = 0;
    for (const Image& level : source)
        wanted += blockBytes(level, format);
    const Result<Bytes> bytes = readFile(file, wanted + maxHeaderBytes);
    if (!bytes)
        return std::nullopt;
    Result<TextureImage> found = decodeDds(*bytes);
    // What we wrote gives no notes: it has everything and nothing beyond.
    if (!found || !found->notes.empty() || found->surfaces.size() != source.size())
        return std::nullopt;
    std::vector<BlockImage> levels;
    for (std::size_t i = 0; i < source.size(); ++i) {
        auto* blocks = std::get_if<BlockImage>(&found->surfaces[i]);
        if (blocks == nullptr || blocks->format != format || blocks->width != source[i].width ||
            blocks->height != source[i].height || blocks->depth != 1)
            return std::nullopt;
        levels.push_back(std::move(*blocks));
    }
    std::error_code readOnly; // then it only seems older than it is
    fs::last_write_time(file, fs::file_time_type::clock::now(), readOnly);
    return levels;
}

Result<void> BlockCache::keep(const fs::path& file, std::vector<BlockImage> levels) const {
    if (directory_.empty())
        return fail(ErrorCode::NotFound,
                    "there is no cache directory: neither XDG_CACHE_HOME nor HOME is an absolute path");
    TextureImage entry;
    entry.format = "DDS";
    entry.levels = static_cast<int>(levels.size());
    entry.topFirst = true; // the rows stay as they are
    entry.alpha = AlphaMeaning::Straight;
    for (BlockImage& level : levels)
        entry.surfaces.emplace_back(std::move(level));
    const Result<Bytes> bytes = encodeDds(entry);
    if (!bytes)
        return fail(bytes.error());
    if (bytes->size() > maxBytes_)
        return fail(ErrorCode::TooLarge, "its " + std::to_string(bytes->size()) +
                                             " bytes exceed the cache's bound of " +
                                             std::to_string(maxBytes_));
    std::error_code error;
    fs::create_directories(directory_, error);
    if (error)
        return fail(ErrorCode::Unwritable, "the cache directory can't be made: " + error.message(),
                    directory_.string());
    makeRoom(directory_, maxBytes_ - bytes->size(), file); // before: the disk may be as small as the bound
    return writeFileAtomically(file, *bytes);
}

} // namespace texplorer
