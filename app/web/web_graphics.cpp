#include "app/web/web_graphics.h"

#include "app/web/browser.h"
#include "app/web/level_work.h"
#include "texplorer/base/translatable.h"

#include <cstdint>

namespace texplorer::web {
namespace {

view::PictureHandle makePicture(const Image& image, stage::Graphics::Use use) {
    return static_cast<view::PictureHandle>(browser::makeTexture(
        image.pixels.data(), image.width, image.height, use == stage::Graphics::Use::Enlarged));
}

void dropPicture(view::PictureHandle picture) {
    browser::dropTexture(static_cast<unsigned>(picture));
}

void setBlending(const ImDrawList* /*list*/, const ImDrawCmd* command) {
    browser::setBlending(command->UserCallbackData != nullptr);
}

/// The shaders that sample textures themselves have every format and target, of any size that memory holds.
view::Capabilities capabilitiesOfShaders() {
    constexpr int unlimited = 1 << 30;
    view::Capabilities capabilities;
    capabilities.maxTextureSize = capabilities.max3DTextureSize = capabilities.maxCubeMapSize = unlimited;
    capabilities.textureUnits = maxUnits;
    capabilities.maxAnisotropy = 16;
    capabilities.s3tc = capabilities.rgtc = capabilities.floatTextures = true;
    capabilities.seamlessCubeMaps = capabilities.textureBorders = capabilities.shaders = true;
    return capabilities;
}

unsigned textureOf(const ImDrawCmd& command) {
    return static_cast<unsigned>(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
}

void drawCommand(const ImDrawCmd& command, ImVec2 origin, ImVec2 density) {
    const auto pixel = [](float position, float from, float scale) {
        return static_cast<int>((position - from) * scale);
    };
    browser::panelTriangles(
        textureOf(command), static_cast<int>(command.IdxOffset), static_cast<int>(command.ElemCount),
        pixel(command.ClipRect.x, origin.x, density.x), pixel(command.ClipRect.y, origin.y, density.y),
        pixel(command.ClipRect.z, origin.x, density.x), pixel(command.ClipRect.w, origin.y, density.y));
}

} // namespace

WebGraphics::WebGraphics()
    : capabilities_(capabilitiesOfShaders())
    , pictures_({makePicture, dropPicture}) {
    offered_.withhold(RendererKind::Fixed, N_("a browser has no OpenGL with fixed functions"));
}

gles::ScenePainter& WebGraphics::painterOf(view::Side side) {
    std::optional<gles::ScenePainter>& painter = painters_.at(static_cast<std::size_t>(side));
    return painter ? *painter : painter.emplace(device_, levelWork());
}

Result<view::Frame> WebGraphics::draw(RendererKind renderer, view::Side side, const Scene& scene,
                                      const ImageSource& images, double time, view::Size size,
                                      LevelsSource& /*levels*/) {
    if (!offered_.has(renderer))
        return fail(ErrorCode::Unsupported, offered_.whyNot(renderer));
    return painterOf(side).draw(scene, images, time, size);
}

Result<Image> WebGraphics::read(RendererKind renderer, view::Side side) {
    if (!offered_.has(renderer))
        return fail(ErrorCode::Unsupported, offered_.whyNot(renderer));
    return painterOf(side).read();
}

void WebGraphics::makeFonts() {
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    fonts_ = browser::makeTexture(pixels, width, height, false);
    atlas.SetTexID(reinterpret_cast<ImTextureID>( // NOLINT(performance-no-int-to-ptr): it is no pointer
        static_cast<std::uintptr_t>(fonts_)));
}

void WebGraphics::dropFonts() {
    browser::dropTexture(fonts_);
    fonts_ = 0;
}

void WebGraphics::fontsChanged() {
    dropFonts();
    makeFonts();
}

bool WebGraphics::fetchFont() {
    browser::fetchFont();
    return true;
}

void WebGraphics::contextRestored() {
    pictures_.forget();
    for (std::optional<gles::ScenePainter>& painter : painters_) {
        if (painter)
            painter->forgetObjects();
    }
    makeFonts();
}

void WebGraphics::drawPanels(ImDrawData& panels, view::Size pixels, const ImVec4& ground) {
    const ImVec2 density = panels.FramebufferScale;
    browser::beginPanels(pixels.width, pixels.height, density.x, ground.x, ground.y, ground.z);
    for (int i = 0; i < panels.CmdListsCount; ++i) {
        const ImDrawList& list = *panels.CmdLists[i];
        browser::panelList(list.VtxBuffer.Data, list.VtxBuffer.Size, list.IdxBuffer.Data,
                           list.IdxBuffer.Size);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback)
                command.UserCallback(&list, &command);
            else
                drawCommand(command, panels.DisplayPos, density);
        }
    }
}

Image WebGraphics::readPanels(view::Size pixels) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, pixels.width, pixels.height);
    browser::readPanels(image.pixels.data(), image.width, image.height);
    return image;
}

ImDrawCallback WebGraphics::blendingSwitch() const {
    return setBlending;
}

} // namespace texplorer::web
