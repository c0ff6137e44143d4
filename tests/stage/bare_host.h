#pragma once

#include "app/stage/loop.h"
#include "app/ui/model/session.h"
#include "app/ui/services/services.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texplorer::stage {

/// The graphics of a host that has only the reference: pictures are kept in memory, and of the panels only
/// what they are made of is noted.
class PicturesInMemory final : public Graphics {
public:
    PicturesInMemory();

    const view::Capabilities& capabilities() const override { return capabilities_; }
    const view::OfferedRenderers& renderers() const override { return offered_; }
    Result<view::Frame> draw(RendererKind renderer, view::Side side, const Scene& scene,
                             const ImageSource& images, double time, view::Size size,
                             LevelsSource& levels) override;
    Result<Image> read(RendererKind renderer, view::Side side) override;
    view::PictureHandle show(const std::shared_ptr<const Image>& image, Use use) override;
    view::PictureHandle showTexture(const Texture& texture, const ImageSource& images,
                                    LevelsSource& levels) override;
    bool isUploading() const override { return false; }
    void endFrame() override;
    void startPanels() override;
    void endPanels() override {}
    void fontsChanged() override { startPanels(); }
    void beginFrame() override {}
    void drawPanels(ImDrawData& panels, view::Size pixels, const ImVec4& ground) override;
    Image readPanels(view::Size pixels) override;
    ImDrawCallback blendingSwitch() const override { return nullptr; }

    /// The largest picture in the last frame's panels: the view. nullptr: they have none.
    [[nodiscard]] std::shared_ptr<const Image> largest() const;

    std::size_t vertices = 0;                  ///< of the panels in the last frame
    std::vector<view::PictureHandle> pictures; ///< that they show
    int refusals = 0;                          ///< pictures that were requested from a renderer

private:
    view::Capabilities capabilities_;
    view::OfferedRenderers offered_;
    std::map<std::shared_ptr<const Image>, view::PictureHandle> handles_;
    std::size_t lastHandle_ = 0;
};

/// Files that have a name and a content, but no place on a disk.
class FilesInMemory final : public ui::Files {
public:
    explicit FilesInMemory(const std::map<std::string, Bytes>& known)
        : known_(known) {}

    Ticket load(std::filesystem::path path, Wanted wanted) override;
    void cancel(Ticket ticket) override;
    std::vector<ImageLoader::Loaded> take() override { return std::exchange(loaded_, {}); }
    std::optional<ImageLoader::Progress> progress() const override { return std::nullopt; }
    void watch(std::vector<std::filesystem::path> /*files*/) override {}
    std::vector<std::filesystem::path> changed() override { return {}; }
    void wait() const override {}

private:
    const std::map<std::string, Bytes>& known_;
    Ticket last_ = 0;
    std::vector<ImageLoader::Loaded> loaded_;
};

/// What it makes is saved like the other files.
class WritingInMemory final : public ui::FileWriting {
public:
    explicit WritingInMemory(std::vector<std::vector<NamedFile>>& saved)
        : FileWriting(When::AtOnce)
        , saved_(saved) {}

protected:
    Result<std::filesystem::path> put(const ui::FileOrder& order, ByteView bytes) override;

private:
    std::vector<std::vector<NamedFile>>& saved_;
};

/// A host such as a browser: it has no OpenGL, files, folders, threads or clipboard. Its user chooses files
/// when it asks, and receives the saved ones.
class BareHost {
public:
    /// `chosen`: the renderer that the user has chosen in another window.
    explicit BareHost(const Surface& surface, std::optional<RendererKind> chosen = {});

    /// Takes events and draws frames until the window waits for the next event or a later time.
    void run(std::vector<Event> events = {});

    std::map<std::string, Bytes> known; ///< files that scenes may name
    PicturesInMemory graphics;
    ui::OwnedServices<FilesInMemory> services{When::AtOnce, {}, LevelWork{}, known};
    std::vector<std::vector<NamedFile>> saved; ///< each a requested file with those that it needs
    WritingInMemory writing{saved};
    ui::Session session{servicesOf(*this)};
    std::vector<FileWish> wishes; ///< requests for files to open
    Loop loop;
    double now = 0; ///< seconds
    Step last;
    int drawn = 0; ///< frames of the last run

private:
    static ui::Services servicesOf(BareHost& host);
};

} // namespace texplorer::stage
