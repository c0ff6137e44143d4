// A frame as a host without OpenGL gets it.

#include "app/stage/stage.h"
#include "app/ui/widgets/keys.h"

#include <gmock/gmock.h>

#include <map>

namespace texplorer::stage {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Keeps pictures as numbers and counts what it is asked for. It has the fixed function, and no shaders.
class NumbersForPictures final : public Graphics {
public:
    NumbersForPictures() {
        facts.renderer = "made up";
        facts.maxTextureSize = 16384;
        facts.textureUnits = 8;
        facts.maxAnisotropy = 16;
    }

    const view::Capabilities& capabilities() const override { return facts; }
    Result<view::Frame> draw(RendererKind renderer, const Scene& /*scene*/, const ImageSource& /*images*/,
                             double /*time*/, view::Size size, LevelsSource& /*levels*/) override {
        drawn.push_back(renderer);
        if (renderer != RendererKind::Fixed)
            return fail(ErrorCode::Driver, "there are no shaders here");
        view::Frame frame;
        frame.texture = 1000;
        frame.size = size;
        frame.revision = 7;
        return frame;
    }
    Result<Image> read(RendererKind /*renderer*/) override {
        ++reads;
        return Image::uninitialised(PixelFormat::Rgba8, pixels.width, pixels.height);
    }
    unsigned show(const std::shared_ptr<const Image>& image, Use use) override {
        if (!image)
            return 0;
        shown[image] = use;
        return static_cast<unsigned>(shown.size());
    }
    unsigned showTexture(const Texture& /*texture*/, const ImageSource& /*images*/,
                         LevelsSource& /*levels*/) override {
        return 2000;
    }
    bool isUploading() const override { return uploading; }
    void endFrame() override { ++frames; }
    void startPanels() override {
        unsigned char* alpha = nullptr;
        int width = 0;
        int height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alpha, &width, &height);
        started = true;
    }
    void endPanels() override { started = false; }
    void fontsChanged() override {
        ++fonts;
        startPanels();
    }
    void beginFrame() override {}
    void drawPanels(ImDrawData& panels, view::Size size) override {
        pixels = size;
        pictures.clear();
        for (int i = 0; i < panels.CmdListsCount; ++i) {
            for (const ImDrawCmd& command : panels.CmdLists[i]->CmdBuffer)
                pictures.push_back(
                    static_cast<unsigned>(reinterpret_cast<std::uintptr_t>(command.TextureId)));
        }
    }
    ImDrawCallback blendingSwitch() const override { return nullptr; }

    view::Capabilities facts;
    std::vector<RendererKind> drawn;
    std::map<std::shared_ptr<const Image>, Use> shown;
    std::vector<unsigned> pictures; ///< that the panels of the last frame are drawn with
    view::Size pixels;
    int reads = 0;
    int frames = 0;
    int fonts = 0;
    bool uploading = false;
    bool started = false;
};

class StageTest : public testing::Test {
protected:
    ui::Requests frame(float scale = 1) {
        ui::mapKeys();
        ImGui::GetIO().DeltaTime = 1.0F / 60;
        return stage.draw(session, {{1280, 800}, {1280, 800}, scale});
    }
    NumbersForPictures graphics;
    Stage stage{graphics, 1};
    ui::ServicesAtOnce services;
    ui::Session session{services.lend()};
};

TEST_F(StageTest, AFrameIsDrawnByWhatTheHostLends) {
    const ui::Requests requests = frame();
    EXPECT_THAT(requests.title, HasSubstr("Untitled"));
    EXPECT_THAT(graphics.drawn, ElementsAre(RendererKind::Fixed));
    EXPECT_EQ(graphics.pixels, (view::Size{1280, 800}));
    EXPECT_EQ(graphics.frames, 1);
    frame();
    EXPECT_THAT(graphics.pictures, Contains(1000U)) << "the view";
    EXPECT_THAT(graphics.pictures, Contains(2000U)) << "the texture space";
    EXPECT_EQ(graphics.reads, 0) << "nobody asked for pixels";
    EXPECT_THAT(stage.problems(), IsEmpty());
}

TEST_F(StageTest, TheReferenceNeedsNoRenderer) {
    showOne(session.window.view, RendererKind::Reference);
    frame();
    EXPECT_THAT(graphics.drawn, IsEmpty());
    ASSERT_THAT(graphics.shown, SizeIs(1));
    EXPECT_EQ(graphics.shown.begin()->second, Graphics::Use::Enlarged);
    EXPECT_GT(graphics.shown.begin()->first->width, 100);
    EXPECT_THAT(stage.problems(), IsEmpty());
}

TEST_F(StageTest, ARendererThatThereIsNotIsSaid) {
    showOne(session.window.view, RendererKind::Shader);
    frame();
    EXPECT_THAT(stage.problems(), ElementsAre(HasSubstr("there are no shaders here")));
}

TEST_F(StageTest, PixelsAreReadOnceForEachPicture) {
    showComparison(session.window.view, {RendererKind::Fixed, RendererKind::Reference});
    for (int i = 0; i < 3; ++i)
        frame();
    EXPECT_EQ(graphics.reads, 1) << "its revision stays";
}

TEST_F(StageTest, AnUploadAsksForAnotherFrame) {
    EXPECT_FALSE(frame().unfinished);
    graphics.uploading = true;
    EXPECT_TRUE(frame().unfinished);
}

TEST_F(StageTest, AnotherScaleMakesTheFontsAgain) {
    frame();
    EXPECT_EQ(graphics.fonts, 0);
    frame(2);
    EXPECT_EQ(graphics.fonts, 1);
    frame(2);
    EXPECT_EQ(graphics.fonts, 1);
}

TEST(StagesEndTest, ThePanelsEndWithTheStage) {
    NumbersForPictures graphics;
    {
        const Stage stage(graphics, 1);
        EXPECT_TRUE(graphics.started);
    }
    EXPECT_FALSE(graphics.started);
}

} // namespace
} // namespace texplorer::stage
