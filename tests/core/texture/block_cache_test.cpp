// Compressed levels are found the next time, and no content of the directory can do harm.

#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/dds/dds.h"
#include "texplorer/files/file_io.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/texture/levels_worker.h"
#include "texplorer/texture/texture_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#define XXH_INLINE_ALL
#include <chrono>
#include <cstring>
#include <fstream>
#include <set>
#include <xxhash.h>

namespace texplorer::block_cache_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Soft colours with alpha; not the same upside down.
Image softPicture(int width, int height) {
    Image made = Image::uninitialised(PixelFormat::Rgba8, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array values{40 + x * 3, 60 + y * 3, 128 + x - y, x % 4 == 0 ? 0 : 255};
            std::ranges::transform(values, made.at(x, y).begin(), [](int v) { return std::byte(v & 255); });
        }
    return made;
}

TextureImage softFile(int width = 24, int height = 20) {
    return textureOf(softPicture(width, height), "BMP");
}

Texture cachedTexture(CompressedFormat format = CompressedFormat::Dxt5) {
    Texture texture;
    texture.compression = Compression::Cached;
    texture.compressedFormat = format;
    texture.compressionQuality = EncodeQuality::Fast;
    texture.mipmaps = MipPolicy::Generated;
    return texture;
}

std::vector<BlockImage> blocksOf(const TextureLevels& levels) {
    std::vector<BlockImage> blocks;
    for (const TextureLevel& level : levels.levels)
        blocks.push_back(std::get<BlockImage>(*level.surface));
    return blocks;
}

class Cache : public testing::Test {
protected:
    test::TempDir folder;
    BlockCache cache{folder / "blocks"};

    TextureLevels prepare(const Texture& texture = cachedTexture(), const TextureImage& image = softFile()) {
        Result<TextureLevels> levels = prepareLevels(texture, image, Target::Texture2D, {cache});
        EXPECT_TRUE(levels) << describe(levels.error());
        return levels ? *std::move(levels) : TextureLevels{};
    }
    std::set<fs::path> entries() const {
        std::set<fs::path> found;
        if (fs::exists(cache.directory()))
            for (const auto& file : fs::directory_iterator(cache.directory()))
                found.insert(file.path());
        return found;
    }
    fs::path onlyEntry() const {
        EXPECT_EQ(entries().size(), 1U);
        return entries().empty() ? fs::path() : *entries().begin();
    }
};

struct FormatCase {
    const char* name;
    CompressedFormat format;
};

class CacheOf : public Cache, public testing::WithParamInterface<FormatCase> {};

TEST_P(CacheOf, AFormatMissesOnceThenGivesTheSameBlocks) {
    const Texture texture = cachedTexture(GetParam().format);
    const TextureLevels made = prepare(texture);
    EXPECT_FALSE(made.fromCache);
    EXPECT_THAT(made.notes, IsEmpty());
    ASSERT_EQ(made.levels.size(), 5U);
    ASSERT_EQ(made.source.size(), 5U);
    EXPECT_EQ(made.source[0], softPicture(24, 20)) << "upright, as it was before";

    const TextureLevels found = prepare(texture);
    EXPECT_TRUE(found.fromCache);
    EXPECT_THAT(found.notes, IsEmpty());
    EXPECT_EQ(blocksOf(found), blocksOf(made));
    EXPECT_EQ(found.source, made.source);

    // The expected levels come from the encoder itself.
    for (std::size_t i = 0; i < made.levels.size(); ++i)
        EXPECT_EQ(blocksOf(made)[i],
                  *encodeBlocks(made.source[i], blockFormat(GetParam().format), EncodeQuality::Fast));
}

INSTANTIATE_TEST_SUITE_P(Formats, CacheOf,
                         testing::Values(FormatCase{"Dxt1", CompressedFormat::Dxt1},
                                         FormatCase{"Dxt1Alpha", CompressedFormat::Dxt1Alpha},
                                         FormatCase{"Dxt3", CompressedFormat::Dxt3},
                                         FormatCase{"Dxt5", CompressedFormat::Dxt5}),
                         [](const auto& test) { return std::string(test.param.name); });

/// As the header says: a hash of the name and all bytes except the 16 of dwReserved1.
void sign(const fs::path& entry, Bytes& file) {
    const std::string name = entry.filename();
    const auto begin = file.begin();
    Bytes covered;
    for (const char c : name)
        covered.push_back(static_cast<std::byte>(c));
    covered.insert(covered.end(), begin, begin + 32);
    covered.insert(covered.end(), begin + 48, file.end());
    XXH128_canonical_t digest;
    XXH128_canonicalFromHash(&digest, XXH3_128bits(covered.data(), covered.size()));
    std::memcpy(file.data() + 32, digest.digest, 16);
}

TEST_F(Cache, ReadsTheFileAndNotSomeCopyOfItsOwn) {
    const TextureLevels made = prepare();
    Bytes file = *readFile(onlyEntry());
    // The blocks are at the end of the file: 128 bytes of header, then 6 x 5 blocks of 16 bytes, then the
    // smaller levels.
    const std::size_t blocks = 128;
    for (std::size_t i = blocks; i < file.size(); i += 16)
        std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(i), 16, std::byte{0x42});
    sign(onlyEntry(), file);
    ASSERT_TRUE(writeFileAtomically(onlyEntry(), file));
    const TextureLevels found = prepare();
    EXPECT_TRUE(found.fromCache);
    for (const BlockImage& level : blocksOf(found))
        EXPECT_THAT(level.blocks, testing::Each(std::byte{0x42}));
}

TEST_F(Cache, EntriesAreFilesThatOthersRead) {
    const TextureLevels made = prepare();
    const Result<TextureImage> read = decodeDds(*readFile(onlyEntry()));
    ASSERT_TRUE(read);
    EXPECT_THAT(read->notes, IsEmpty()) << "the content of dwReserved1 is ignored";
    EXPECT_EQ(std::get<BlockImage>(read->surfaces[0]), blocksOf(made)[0]);
}

TEST_F(Cache, BelievesNoEntryInWhichABitHasFlipped) {
    const TextureLevels made = prepare();
    const fs::path entry = onlyEntry();
    Bytes file = *readFile(entry);
    ASSERT_TRUE(cache.find(entry, made.source, BlockFormat::Dxt5));
    std::size_t believed = 0;
    for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
        const std::byte mask{static_cast<unsigned char>(1U << bit % 8)};
        file[bit / 8] ^= mask;
        test::writeRaw(entry, file);
        believed += cache.find(entry, made.source, BlockFormat::Dxt5) ? 1U : 0U;
        file[bit / 8] ^= mask;
    }
    EXPECT_EQ(believed, 0U) << "of " << 8 * file.size();
    test::writeRaw(entry, file);
    EXPECT_TRUE(cache.find(entry, made.source, BlockFormat::Dxt5));
}

TEST_F(Cache, BelievesNoEntryUnderTheNameOfAnother) {
    static_cast<void>(prepare());
    const fs::path first = onlyEntry();
    TextureImage file = softFile();
    std::get<Image>(file.surfaces[0]).at(5, 5)[0] ^= std::byte{1};
    const TextureLevels made = prepare(cachedTexture(), file);
    for (const fs::path& entry : entries())
        if (entry != first)
            fs::copy_file(first, entry, fs::copy_options::overwrite_existing);
    const TextureLevels again = prepare(cachedTexture(), file);
    EXPECT_FALSE(again.fromCache);
    EXPECT_EQ(blocksOf(again), blocksOf(made));
}

TEST_F(Cache, WritesThroughNoLink) {
    static_cast<void>(prepare());
    const fs::path entry = onlyEntry();
    const Bytes sound = *readFile(entry);
    const fs::path precious = folder / "precious";
    for (const bool whole : {false, true}) { // a link to a valid entry is not read either
        test::writeRaw(precious, whole ? sound : Bytes(5, std::byte{'!'}));
        fs::remove(entry);
        fs::create_symlink(precious, entry);
        EXPECT_FALSE(prepare().fromCache);
        EXPECT_EQ(*readFile(precious), whole ? sound : Bytes(5, std::byte{'!'}));
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(entry)));
        EXPECT_EQ(*readFile(entry), sound);
    }
}

TEST_F(Cache, IsADirectoryOfMode0700OrNone) {
    static_cast<void>(prepare());
    EXPECT_EQ(fs::status(cache.directory()).permissions(), fs::perms::owner_all);
    EXPECT_EQ(fs::status(onlyEntry()).permissions(), fs::perms::owner_read | fs::perms::owner_write);

    fs::permissions(cache.directory(), fs::perms::all);
    const TextureLevels refused = prepare();
    EXPECT_FALSE(refused.fromCache) << "anybody may have put it there";
    EXPECT_THAT(refused.notes,
                ElementsAre(HasSubstr("the cache directory is writable by others: expected mode 0700, "
                                      "found 0777")));
    fs::permissions(cache.directory(), fs::perms::owner_all);
    EXPECT_TRUE(prepare().fromCache);

    fs::rename(cache.directory(), folder / "elsewhere");
    fs::create_directory_symlink("elsewhere", cache.directory());
    const TextureLevels linked = prepare();
    EXPECT_FALSE(linked.fromCache);
    EXPECT_THAT(linked.notes, ElementsAre(HasSubstr("the cache directory is a link, not a directory")));
}

struct Damage {
    const char* name;
    void (*change)(Bytes& file);
};

class DamagedEntry : public Cache, public testing::WithParamInterface<Damage> {};

TEST_P(DamagedEntry, IsIgnoredAndRewritten) {
    const TextureLevels made = prepare();
    const Bytes sound = *readFile(onlyEntry());
    Bytes damaged = sound;
    GetParam().change(damaged);
    ASSERT_NE(damaged, sound);
    ASSERT_TRUE(writeFileAtomically(onlyEntry(), damaged));
    const TextureLevels again = prepare();
    EXPECT_FALSE(again.fromCache);
    EXPECT_THAT(again.notes, IsEmpty());
    EXPECT_EQ(blocksOf(again), blocksOf(made));
    EXPECT_EQ(*readFile(onlyEntry()), sound);
    EXPECT_TRUE(prepare().fromCache);
}

/// A valid DDS file, but not of this texture.
void replaceBy(Bytes& file, BlockFormat format, int width, int height, int levels) {
    TextureImage other;
    other.topFirst = true;
    other.levels = levels;
    for (int level = 0; level < levels; ++level)
        other.surfaces.emplace_back(
            *encodeBlocks(softPicture(std::max(1, width >> level), std::max(1, height >> level)), format,
                          EncodeQuality::Fast));
    file = *encodeDds(other);
}

INSTANTIATE_TEST_SUITE_P(
    Damages, DamagedEntry,
    testing::Values(
        Damage{"Empty", [](Bytes& file) { file.clear(); }},
        Damage{"CutInTheHeader", [](Bytes& file) { file.resize(100); }},
        Damage{"CutAfterTheHeader", [](Bytes& file) { file.resize(128); }},
        Damage{"CutInTheBlocks", [](Bytes& file) { file.resize(file.size() / 2); }},
        Damage{"OneByteShort", [](Bytes& file) { file.resize(file.size() - 1); }},
        Damage{"OneByteMore", [](Bytes& file) { file.push_back(std::byte{1}); }},
        Damage{"FarTooLong", [](Bytes& file) { file.resize(file.size() + 100000); }},
        Damage{"Garbage", [](Bytes& file) { std::ranges::fill(file, std::byte{0x5A}); }},
        Damage{"AnotherFormat", [](Bytes& file) { replaceBy(file, BlockFormat::Dxt3, 24, 20, 5); }},
        Damage{"AnotherSize", [](Bytes& file) { replaceBy(file, BlockFormat::Dxt5, 20, 24, 5); }},
        Damage{"FewerLevels", [](Bytes& file) { replaceBy(file, BlockFormat::Dxt5, 24, 20, 4); }}),
    [](const auto& test) { return std::string(test.param.name); });

struct Setting {
    const char* name;
    void (*change)(Texture& texture);
};

class OtherSetting : public Cache, public testing::WithParamInterface<Setting> {};

TEST_P(OtherSetting, HasAnEntryOfItsOwn) {
    TextureImage file = softFile(25, 20); // 25: gamma, filter and power of two make a difference
    file.fileTopFirst = true;
    Texture texture = cachedTexture();
    static_cast<void>(prepare(texture, file));
    GetParam().change(texture);
    EXPECT_FALSE(prepare(texture, file).fromCache);
    EXPECT_EQ(entries().size(), 2U);
    EXPECT_TRUE(prepare(texture, file).fromCache);
}

INSTANTIATE_TEST_SUITE_P(
    Settings, OtherSetting,
    testing::Values(
        Setting{"Format", [](Texture& other) { other.compressedFormat = CompressedFormat::Dxt3; }},
        Setting{"OneBitAlpha", [](Texture& other) { other.compressedFormat = CompressedFormat::Dxt1Alpha; }},
        Setting{"Quality", [](Texture& other) { other.compressionQuality = EncodeQuality::Normal; }},
        Setting{"Flip", [](Texture& other) { other.flip = FlipMode::None; }},
        Setting{"Mipmaps", [](Texture& other) { other.mipmaps = MipPolicy::Colored; }},
        Setting{"NoMipmaps", [](Texture& other) { other.mipmaps = MipPolicy::None; }},
        Setting{"Filter", [](Texture& other) { other.mipFilter = MipFilter::Mitchell; }},
        Setting{"Gamma", [](Texture& other) { other.mipGamma = true; }},
        Setting{"PowerOfTwo", [](Texture& other) { other.npot = NpotPolicy::PowerOfTwo; }},
        Setting{"Transparency", [](Texture& other) { other.transparency = Transparency::Solid; }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_F(Cache, HasAnEntryForEveryPicture) {
    static_cast<void>(prepare());
    TextureImage other = softFile();
    std::get<Image>(other.surfaces[0]).at(5, 5)[0] ^= std::byte{1};
    EXPECT_FALSE(prepare(cachedTexture(), other).fromCache);
    EXPECT_EQ(entries().size(), 2U);
    // The same number of bytes, but another shape.
    EXPECT_FALSE(prepare(cachedTexture(), softFile(20, 24)).fromCache);
    EXPECT_EQ(entries().size(), 3U);
}

TEST_F(Cache, WithoutADirectoryOnlyCostsTime) {
    fs::create_directory(folder / "file");
    std::ofstream(folder / "file" / "in the way") << "not a directory";
    for (const auto& [place, words] :
         {std::pair{BlockCache(folder / "file" / "in the way"), "in the way: "},
          {BlockCache(folder / "file" / "in the way" / "below"), "in the way/below: "},
          {BlockCache("/proc/no such place"), "/proc/no such place: the cache directory can't be made"},
          {BlockCache(), "there is no cache directory: neither XDG_CACHE_HOME nor HOME"},
          {BlockCache(folder / "small", 100), "exceed the cache's limit of 100"}}) {
        cache = place;
        const TextureLevels levels = prepare();
        EXPECT_FALSE(levels.fromCache);
        EXPECT_EQ(levels.levels.size(), 5U);
        EXPECT_THAT(levels.notes, ElementsAre(HasSubstr(words)));
    }
}

TEST_F(Cache, NeverTakesMoreThanItsBoundAndDropsWhatWasUsedLongestAgo) {
    // 16 x 16 without mipmaps: 128 + 16 * 16 bytes an entry; three fit.
    cache = BlockCache(cache.directory(), 3 * 384);
    Texture texture = cachedTexture();
    texture.mipmaps = MipPolicy::None;
    const auto picture = [](int i) {
        TextureImage file = softFile(16, 16);
        std::get<Image>(file.surfaces[0]).at(0, 0)[0] = static_cast<std::byte>(i);
        return file;
    };
    const auto now = fs::file_time_type::clock::now();
    std::array<fs::path, 3> files;
    for (int i = 0; i < 3; ++i) {
        const auto before = entries();
        static_cast<void>(prepare(texture, picture(i)));
        for (const fs::path& entry : entries())
            if (!before.contains(entry))
                files[static_cast<std::size_t>(i)] = entry;
    }
    ASSERT_EQ(entries().size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
        fs::last_write_time(files[i], now - std::chrono::hours(10 - i));
    EXPECT_TRUE(prepare(texture, picture(0)).fromCache); // the oldest becomes the newest
    const fs::path foreign = cache.directory() / "notes.txt";
    std::ofstream(foreign) << std::string(5000, '.'); // another program's file: neither counted nor removed
    fs::last_write_time(foreign, now - std::chrono::hours(100));

    static_cast<void>(prepare(texture, picture(3)));
    EXPECT_EQ(entries().size(), 4U);
    EXPECT_TRUE(fs::exists(files[0]));
    EXPECT_FALSE(fs::exists(files[1])) << "used longest ago";
    EXPECT_TRUE(fs::exists(files[2]));
    EXPECT_TRUE(fs::exists(foreign));

    fs::last_write_time(files[0], now + std::chrono::hours(24 * 365));
    static_cast<void>(prepare(texture, picture(4)));
    EXPECT_FALSE(fs::exists(files[0])) << "a date to come doesn't keep it for ever";
    EXPECT_TRUE(fs::exists(files[2]));
}

TEST_F(Cache, RemovesDraftsThatAKilledProgramLeft) {
    cache = BlockCache(cache.directory(), 2000);
    fs::create_directories(cache.directory());
    const fs::path draft = cache.directory() / ".texplorer-4711-0.tmp";
    std::ofstream(draft) << std::string(1900, '.');
    static_cast<void>(prepare());
    EXPECT_FALSE(fs::exists(draft));
    EXPECT_EQ(entries().size(), 1U);
}

TEST_F(Cache, AStopLeavesNothing) {
    std::stop_source stop;
    stop.request_stop();
    const auto levels =
        prepareLevels(cachedTexture(), softFile(), Target::Texture2D, {cache, {}, stop.get_token()});
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().code, ErrorCode::Cancelled);
    EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(Cache, SaysHowFarItIs) {
    std::vector<float> said;
    const LevelWork work{cache, [&](float done) { said.push_back(done); }, {}};
    ASSERT_TRUE(prepareLevels(cachedTexture(), softFile(64, 64), Target::Texture2D, work));
    ASSERT_GE(said.size(), 7U) << "after every level at least";
    EXPECT_TRUE(std::ranges::is_sorted(said));
    EXPECT_NEAR(said.back(), 1, 1e-5);
    EXPECT_GT(said.front(), 0);
    said.clear();
    ASSERT_TRUE(prepareLevels(cachedTexture(), softFile(64, 64), Target::Texture2D, work));
    EXPECT_THAT(said, IsEmpty()) << "nothing was compressed";
}

TEST_F(Cache, TakesThePlaceThatXdgSays) {
    const auto set = [](const char* name, const char* value) {
        value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
    };
    struct Row {
        const char* xdg;
        const char* home;
        const char* expected;
    };
    const char* home = std::getenv("HOME");
    const std::string oldHome = home == nullptr ? "" : home;
    for (const auto& [xdg, at, expected] :
         {Row{"/x/c", "/h", "/x/c/texplorer/blocks"}, Row{nullptr, "/h", "/h/.cache/texplorer/blocks"},
          Row{"", "/h", "/h/.cache/texplorer/blocks"}, Row{"relative", "/h", "/h/.cache/texplorer/blocks"},
          Row{nullptr, nullptr, ""}, Row{"relative", "relative", ""}}) {
        set("XDG_CACHE_HOME", xdg);
        set("HOME", at);
        EXPECT_EQ(BlockCache::ofUser().directory(), expected);
    }
    set("XDG_CACHE_HOME", nullptr);
    set("HOME", home == nullptr ? nullptr : oldHome.c_str());
}

TEST_F(Cache, TargetsWithoutCompressionAreNotCompressed) {
    for (const Target target : {Target::Texture1D, Target::Texture3D}) {
        const auto levels = prepareLevels(cachedTexture(), softFile(), target, {cache});
        ASSERT_TRUE(levels);
        EXPECT_THAT(levels->notes, ElementsAre(HasSubstr("compressed pictures only")));
    }
    EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(Cache, IsUsedByTheWorkerThatMakesLevelsBesideTheWindow) {
    LevelsRequest request{std::make_shared<const TextureImage>(softFile(64, 64)),
                          imageSettings(cachedTexture()), Target::Texture2D};
    for (const bool again : {false, true}) {
        LevelsWorker worker(LevelsWorker::When::WhenReady, {}, {cache});
        EXPECT_EQ(worker.prepare(request), nullptr) << "it is not waited for, regardless of its size";
        worker.wait();
        worker.receive();
        const auto levels = worker.prepare(request);
        ASSERT_TRUE(levels && *levels);
        EXPECT_EQ((*levels)->fromCache, again);
        EXPECT_EQ(entries().size(), 1U);
        ASSERT_NE(worker.summary(request), nullptr);
        EXPECT_TRUE(worker.summary(request)->report.levels[0].psnr);
    }
}

} // namespace
} // namespace texplorer::block_cache_test
