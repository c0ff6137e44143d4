#include "texplorer/texture/block_cache.h"

#include "texplorer/codec/dds/dds.h"
#include "texplorer/files/directory_listing.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/private_directory.h"
#include "texplorer/files/user_folder.h"
#include "texplorer/s3tc/encode.h"

#define XXH_INLINE_ALL // the header is all of it: no library to link

#include <algorithm>
#include <array>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <memory>
#include <new>
#include <sys/stat.h>
#include <xxhash.h>

namespace texplorer {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t hashDigits = 32;
constexpr std::size_t maxHeaderBytes = 148; // of a DDS file with the DX10 header

using Digest = std::array<std::byte, sizeof(XXH128_canonical_t)>;

class Hash {
public:
    Hash() {
        if (!state_)
            throw std::bad_alloc();
        XXH3_128bits_reset(state_.get());
    }
    void add(ByteView bytes) { XXH3_128bits_update(state_.get(), bytes.data(), bytes.size()); }
    template<class... Numbers>
    void addNumbers(Numbers... numbers) {
        const std::array all{static_cast<std::uint32_t>(numbers)...};
        add(std::as_bytes(std::span(all)));
    }
    [[nodiscard]] Digest digest() const {
        XXH128_canonical_t bytes;
        XXH128_canonicalFromHash(&bytes, XXH3_128bits_digest(state_.get()));
        Digest digest;
        std::memcpy(digest.data(), bytes.digest, digest.size());
        return digest;
    }

private:
    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_{XXH3_createState(), XXH3_freeState};
};

std::string hexadecimal(const Digest& digest) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (const std::byte byte : digest) {
        text += digits[std::to_integer<unsigned>(byte) >> 4];
        text += digits[std::to_integer<unsigned>(byte) & 15];
    }
    return text;
}

std::string keyOf(const MipChain& source, BlockFormat format, EncodeQuality quality) {
    Hash hash;
    hash.addNumbers(encoderVersion, format, quality, source.size());
    for (const Image& level : source) {
        hash.addNumbers(level.format, level.width, level.height, level.depth);
        hash.add(level.pixels);
    }
    return hexadecimal(hash.digest());
}

/// dwReserved1, which readers of DDS files ignore.
constexpr std::size_t checksumAt = 32;

/// Of all bytes but its own, and of the name: an entry under another's name is damaged, too.
Digest checksumOf(const std::string& name, ByteView entry) {
    Hash hash;
    hash.add(viewBytes(name));
    hash.add(entry.first(checksumAt));
    hash.add(entry.subspan(checksumAt + sizeof(Digest)));
    return hash.digest();
}

bool isSound(const std::string& name, ByteView entry) {
    return entry.size() >= checksumAt + sizeof(Digest) &&
           std::ranges::equal(entry.subspan(checksumAt, sizeof(Digest)), checksumOf(name, entry));
}

std::size_t blockBytes(const Image& level, BlockFormat format) {
    return (static_cast<std::size_t>(level.width) + 3) / 4 *
           ((static_cast<std::size_t>(level.height) + 3) / 4) * bytesPerBlock(format);
}

bool isEntryName(std::string_view name) {
    return name.size() == hashDigits + 4 && name.ends_with(".dds") &&
           name.find_first_not_of("0123456789abcdef") == hashDigits;
}

/// Removes the oldest entries until at most `maxBytes` are left without `replaced`, which will be written.
void makeRoom(const PrivateDirectory& directory, std::uintmax_t maxBytes, const std::string& replaced) {
    struct Entry {
        std::string name;
        std::uintmax_t bytes;
        std::int64_t used; ///< nanoseconds
    };
    const int place = directory.descriptor().get();
    const auto nanoseconds = [](const timespec& time) {
        return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
    };
    timespec clock = {};
    ::clock_gettime(CLOCK_REALTIME, &clock);
    std::vector<Entry> entries;
    std::uintmax_t sum = 0;
    forEachName(place, [&](const std::string& name) {
        struct stat info = {};
        if (!isEntryName(name) || name == replaced ||
            ::fstatat(place, name.c_str(), &info, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(info.st_mode))
            return;
        const auto bytes = static_cast<std::uintmax_t>(info.st_size);
        const std::int64_t used = nanoseconds(info.st_mtim);
        sum += bytes;
        // A date to come says nothing of its use, and would keep it for ever.
        entries.push_back({name, bytes, used <= nanoseconds(clock) ? used : 0});
    });
    std::ranges::sort(entries, {}, &Entry::used);
    for (const Entry& entry : entries) {
        if (sum <= maxBytes)
            return;
        if (::unlinkat(place, entry.name.c_str(), 0) == 0)
            sum -= entry.bytes;
    }
}

} // namespace

BlockCache::BlockCache(fs::path directory, std::uintmax_t maxBytes)
    : directory_(std::move(directory))
    , maxBytes_(maxBytes) {}

BlockCache BlockCache::ofUser() {
    const fs::path caches = userFolder("XDG_CACHE_HOME", ".cache");
    return caches.empty() ? BlockCache() : BlockCache(caches / "texplorer" / "blocks");
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
    const Result<PrivateDirectory> directory = PrivateDirectory::open(directory_);
    if (!directory)
        return std::nullopt;
    const std::string name = file.filename().string();
    const Descriptor entry = directory->openFile(name);
    const Result<Bytes> bytes = readOpened(entry, file.string(), wanted + maxHeaderBytes);
    if (!bytes || !isSound(name, *bytes))
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
    static_cast<void>(::futimens(entry.get(), nullptr)); // else it only seems older than it is
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
    Result<Bytes> bytes = encodeDds(entry);
    if (!bytes)
        return fail(bytes.error());
    if (bytes->size() > maxBytes_)
        return fail(ErrorCode::TooLarge,
                    Sentence("its {0} bytes exceed the cache's limit of {1}", bytes->size(), maxBytes_));
    const std::string name = file.filename().string();
    std::ranges::copy(checksumOf(name, *bytes), bytes->begin() + checksumAt);
    const Result<PrivateDirectory> directory = PrivateDirectory::make(directory_);
    if (!directory)
        return fail(directory.error().code, Sentence("the cache directory {0}", directory.error().message),
                    directory.error().where);
    makeRoom(*directory, maxBytes_ - bytes->size(), name); // before: the disk may be as small as the bound
    return writeFileAtomically(directory->descriptor(), name, *bytes, file.string());
}

} // namespace texplorer
