#pragma once

#include "app/stage/stage.h"

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace texplorer::stage {

/// A host without OpenGL: keeps pictures as numbers and counts what it is asked for. It has the fixed
/// function, and no shaders, unless a test says otherwise.
class NumbersForPictures final : public Graphics {
public:
    NumbersForPictures() {
        facts.renderer = "made up";
        facts.maxTextureSize = 16384;
        facts.textureUnits = 8;
        facts.maxAnisotropy = 16;
        offered.withhold(RendererKind::Shader, "there are no shaders here");
    }

    const view::Capabilities& capabilities() const override { return facts; }
    const view::OfferedRenderers& renderers() const override { return offered; }
    Result<view::Frame> draw(RendererKind renderer, view::Side side, const Scene& scene,
                             const ImageSource& /*images*/, double /*time*/, view::Size size,
                             LevelsSource& /*levels*/) override {
        drawn.push_back(renderer);
        drawnScenes[side] = scene;
        if (!offered.has(renderer))
            return fail(ErrorCode::Driver, "it was not offered");
        view::Frame frame;
        frame.picture = view::PictureHandle{1000};
        frame.size = size;
        frame.revision = 7;
        return frame;
    }
    Result<Image> read(RendererKind /*renderer*/, view::Side /*side*/) override {
        ++reads;
        return Image::uninitialised(PixelFormat::Rgba8, pixels.width, pixels.height);
    }
    view::PictureHandle show(const std::shared_ptr<const Image>& image, Use use) override {
        if (!image)
            return view::PictureHandle::None;
        shown[image] = use;
        return view::PictureHandle{shown.size()};
    }
    view::PictureHandle showTexture(const Texture& /*texture*/, const ImageSource& /*images*/,
                                    LevelsSource& /*levels*/) override {
        return view::PictureHandle{2000};
    }
    bool isUploading() const override { return uploading; }
    std::unique_ptr<view::CostMeter> costMeter(view::CostSubject /*subject*/) override {
        return std::move(meter);
    }
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
    Image readPanels(view::Size size) override {
        return Image::uninitialised(PixelFormat::Rgba8, size.width, size.height);
    }
    void drawPanels(ImDrawData& panels, view::Size size, const ImVec4& ground) override {
        cleared = ground;
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
    view::OfferedRenderers offered;
    std::unique_ptr<view::CostMeter> meter; ///< for the next one who asks
    std::vector<RendererKind> drawn;
    std::map<view::Side, Scene> drawnScenes; ///< the last ones
    std::map<std::shared_ptr<const Image>, Use> shown;
    std::vector<unsigned> pictures; ///< that the panels of the last frame are drawn with
    view::Size pixels;
    ImVec4 cleared; ///< what to, before the panels were drawn
    int reads = 0;
    int frames = 0;
    int fonts = 0;
    bool uploading = false;
    bool started = false;
};

} // namespace texplorer::stage
