#include "tests/ui/workbench.h"
#include "texplorer/s3tc/encode.h"

#include <gmock/gmock.h>

#include <mutex>

namespace texplorer::ui::memory_tab_test {
namespace {

using namespace test;

class MemoryTab : public Workbench {
protected:
    /// A texture of our own, as a file that is loaded.
    void show(TextureImage image) {
        session->document.images.put("made.dds", std::move(image));
        texture().source = SourceKind::File;
        texture().file = "made.dds";
        frames(2);
    }
    std::shared_ptr<const LevelsSummary> summary() {
        return session->services.levels->summary(
            {session->document.images.find(texture()), imageSettings(texture()), Target::Texture2D});
    }
    static Image plain(int width, int height) {
        return Image::uninitialised(PixelFormat::Rgba8, width, height);
    }
};

TEST_F(MemoryTab, AClickOpensItAndItCanBeAskedFor) {
    EXPECT_FALSE(has("memory:sum"));
    click("tab:Memory");
    for (const char* name : {"memory:sum", "memory:ratio", "memory:level 0"})
        EXPECT_TRUE(has(name)) << name;
    session->window.wantedTab = Tab::File;
    frames(3);
    EXPECT_TRUE(has("file:none"));
    EXPECT_FALSE(has("memory:sum"));
    session->window.wantedTab = Tab::Memory;
    frames(3);
    EXPECT_TRUE(has("memory:sum"));
}

TEST_F(MemoryTab, FollowsTheSettings) {
    show(textureOf(plain(8, 8), "PNG"));
    click("tab:Memory");
    EXPECT_TRUE(has("memory:level 3"));
    EXPECT_EQ(summary()->report.bytes, (64U + 16 + 4 + 1) * 4);
    choose("textures[0].mipmaps", "none");
    EXPECT_TRUE(has("memory:level 0"));
    EXPECT_FALSE(has("memory:level 1"));
    choose("textures[0].compression", "driver");
    EXPECT_EQ(summary()->report.bytes, 4U * 8) << "four blocks of DXT1";
}

TEST_F(MemoryTab, ShowsTheLevelThatIsMissing) {
    show(textureOf(plain(16, 16), "PNG"));
    texture().mipmaps = MipPolicy::Missing;
    click("tab:Memory");
    EXPECT_EQ(summary()->report.levels.size(), 4U);
    EXPECT_TRUE(has("memory:level 2")) << "it has its line, which says so";
}

TEST_F(MemoryTab, SaysWhatWasDoneOtherwise) {
    TextureImage blocks;
    blocks.topFirst = true;
    blocks.surfaces.emplace_back(*encodeBlocks(plain(8, 6), BlockFormat::Dxt1, EncodeQuality::Fast));
    show(std::move(blocks));
    texture().mipmaps = MipPolicy::FromFile;
    click("tab:Memory");
    ASSERT_EQ(summary()->notes.size(), 1U);
    EXPECT_THAT(summary()->notes.front(), testing::HasSubstr("height"));
    EXPECT_TRUE(has("memory:note 0"));
    texture().flip = FlipMode::None;
    frames(2);
    EXPECT_FALSE(has("memory:note 0"));
    EXPECT_EQ(summary()->compressed, BlockFormat::Dxt1);
}

TEST_F(MemoryTab, WithoutATextureThereIsNothingToShow) {
    scene().textures.clear();
    unit().enabled = false;
    click("tab:Memory");
    EXPECT_FALSE(has("memory:sum"));
}

/// With a thread, a large image comes later; the window doesn't wait.
class MemoryLater : public MemoryTab {
protected:
    MemoryLater() { lend(services.lend()); }

    std::mutex held;
    ServicesBeside services{[this] { const std::scoped_lock lock(held); }};
};

TEST_F(MemoryLater, LargeLevelsAreWaitedForAndCanBeCancelled) {
    std::unique_lock hold(held);
    click("tab:Memory");
    show(textureOf(plain(1024, 512), "PNG"));
    EXPECT_TRUE(has("memory:waiting"));
    ASSERT_TRUE(has("making levels"));
    click("cancel:levels");
    EXPECT_FALSE(has("making levels"));
    ASSERT_TRUE(has("memory:retry"));
    click("memory:retry");
    EXPECT_TRUE(has("memory:waiting"));
    hold.unlock();
    session->services.levels->wait();
    frames(2);
    EXPECT_TRUE(has("memory:sum"));
    EXPECT_TRUE(has("memory:level 10"));
    EXPECT_FALSE(has("making levels"));
}

} // namespace
} // namespace texplorer::ui::memory_tab_test
