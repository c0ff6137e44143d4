#include "tests/stage/bare_host.h"

#include "texplorer/codec/registry.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace texplorer::stage {
namespace {

constexpr double frameSeconds = 1.0 / 64;
constexpr int maxFrames = 1000;

Result<ImageLoader::Content> contentOf(const Bytes& bytes, ImageLoader::Wanted wanted) {
    if (wanted == ImageLoader::Wanted::Anatomy)
        return dissectFile(bytes);
    return decodeTexture(bytes).map([](TextureImage image) -> ImageLoader::Content {
        return std::make_shared<const TextureImage>(std::move(image));
    });
}

} // namespace

PicturesInMemory::PicturesInMemory() {
    offered_.withhold(RendererKind::Fixed, "there is no OpenGL here");
    offered_.withhold(RendererKind::Shader, "there is no OpenGL here");
}

Result<view::Frame> PicturesInMemory::draw(RendererKind /*renderer*/, view::Side /*side*/,
                                           const Scene& /*scene*/, const ImageSource& /*images*/,
                                           double /*time*/, view::Size /*size*/, LevelsSource& /*levels*/) {
    ++refusals;
    return fail(ErrorCode::Driver, "it was not offered");
}

Result<Image> PicturesInMemory::read(RendererKind /*renderer*/, view::Side /*side*/) {
    ++refusals;
    return fail(ErrorCode::Driver, "it was not offered");
}

view::PictureHandle PicturesInMemory::show(const std::shared_ptr<const Image>& image, Use /*use*/) {
    if (!image || image->empty())
        return view::PictureHandle::None;
    const auto [place, isNew] = handles_.try_emplace(image);
    if (isNew)
        place->second = view::PictureHandle{++lastHandle_};
    return place->second;
}

view::PictureHandle PicturesInMemory::showTexture(const Texture& /*texture*/, const ImageSource& /*images*/,
                                                  LevelsSource& /*levels*/) {
    return view::PictureHandle::None;
}

/// Pictures that panels do not show are forgotten.
void PicturesInMemory::endFrame() {
    std::erase_if(handles_, [this](const auto& each) {
        return each.first.use_count() == 1 && std::ranges::find(pictures, each.second) == pictures.end();
    });
}

void PicturesInMemory::startPanels() {
    unsigned char* alpha = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alpha, &width, &height);
}

void PicturesInMemory::drawPanels(ImDrawData& panels, view::Size /*pixels*/, const ImVec4& /*ground*/) {
    vertices = static_cast<std::size_t>(panels.TotalVtxCount);
    pictures.clear();
    for (int i = 0; i < panels.CmdListsCount; ++i) {
        for (const ImDrawCmd& command : panels.CmdLists[i]->CmdBuffer)
            pictures.push_back(view::PictureHandle{reinterpret_cast<std::uintptr_t>(command.TextureId)});
    }
}

Image PicturesInMemory::readPanels(view::Size pixels) {
    return Image::uninitialised(PixelFormat::Rgba8, pixels.width, pixels.height);
}

std::shared_ptr<const Image> PicturesInMemory::largest() const {
    std::shared_ptr<const Image> found;
    for (const auto& [image, handle] : handles_) {
        const bool isShown = std::ranges::find(pictures, handle) != pictures.end();
        if (isShown && (!found || image->width * image->height > found->width * found->height))
            found = image;
    }
    return found;
}

ui::Files::Ticket FilesInMemory::load(std::filesystem::path path, Wanted wanted) {
    const auto found = known_.find(path.string());
    Result<ImageLoader::Content> content = found == known_.end()
                                               ? fail(ErrorCode::NotFound, "the host does not have it")
                                               : contentOf(found->second, wanted);
    if (!content)
        content.error().where = path.string();
    loaded_.push_back({++last_, std::move(path), std::move(content)});
    return last_;
}

void FilesInMemory::cancel(Ticket ticket) {
    std::erase_if(loaded_, [ticket](const ImageLoader::Loaded& each) { return each.ticket == ticket; });
}

Result<std::filesystem::path> WritingInMemory::put(const ui::FileOrder& order, ByteView bytes) {
    saved_.push_back({{order.file.string(), Bytes(bytes.begin(), bytes.end())}});
    return order.file;
}

ui::Services BareHost::servicesOf(BareHost& host) {
    ui::Services services = host.services.lend();
    services.writing = host.writing;
    return services;
}

BareHost::BareHost(const Surface& surface, std::optional<RendererKind> chosen)
    : loop(graphics, session, surface, {},
           {[this](const FileWish& wish) { wishes.push_back(wish); },
            [this](std::vector<NamedFile> files) { saved.push_back(std::move(files)); }}) {
    if (chosen)
        showOne(session.view, *chosen);
    else // the window's usual renderer is not the user's choice: no message about it
        static_cast<void>(offerRenderers(session.view, graphics.renderers()));
}

void BareHost::run(std::vector<Event> events) {
    drawn = 0;
    do {
        last = loop.step(now, events);
        drawn += last.drawn ? 1 : 0;
        events.clear();
        now += frameSeconds;
        ASSERT_LT(drawn, maxFrames) << "it never rests";
    } while (last.wake && *last.wake < now);
}

} // namespace texplorer::stage
