#pragma once

#include "app/ui/services/thumbnails.h"
#include "texplorer/files/file_watch.h"
#include "texplorer/texture/image_loader.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace texplorer::ui {

/// Reads files for the window. A request returns a ticket; its result can be taken later, depending on the
/// implementation. Call all functions on one thread.
class Files {
public:
    using Ticket = ImageLoader::Ticket;
    using Wanted = ImageLoader::Wanted;

    Files() = default;
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;
    virtual ~Files() = default;

    [[nodiscard]] virtual Ticket load(std::filesystem::path path, Wanted wanted = Wanted::Texture) = 0;
    /// Cancels a request: it has no result.
    virtual void cancel(Ticket ticket) = 0;
    /// Finished files, in the order of the requests.
    [[nodiscard]] virtual std::vector<ImageLoader::Loaded> take() = 0;
    /// The progress of the current file; nothing if all are done.
    [[nodiscard]] virtual std::optional<ImageLoader::Progress> progress() const = 0;

    /// Watches exactly these files from now on.
    virtual void watch(std::vector<std::filesystem::path> files) = 0;
    /// The files that have changed since the last call.
    [[nodiscard]] virtual std::vector<std::filesystem::path> changed() = 0;

    /// Call in every frame that shows a small picture of a file. `modified` distinguishes versions of a file.
    virtual void askThumbnail(const std::filesystem::path& /*file*/,
                              std::filesystem::file_time_type /*modified*/) {}
    /// The small picture; nullptr: not ready, or not available.
    [[nodiscard]] virtual std::shared_ptr<const Image>
    thumbnail(const std::filesystem::path& /*file*/) const {
        return nullptr;
    }
    /// Call once before each frame. Returns true if a small picture has arrived.
    virtual bool receiveThumbnails() { return false; }

    /// Blocks until all requests are finished.
    virtual void wait() const = 0;
};

/// Reads on its own threads; `wake` is called on those when there is a result.
class FilesBeside final : public Files {
public:
    explicit FilesBeside(const std::function<void()>& wake = {})
        : loader_(wake)
        , thumbnails_(wake)
        , watch_(wake) {}

    [[nodiscard]] Ticket load(std::filesystem::path path, Wanted wanted = Wanted::Texture) override {
        return loader_.load(std::move(path), wanted);
    }
    void cancel(Ticket ticket) override { loader_.cancel(ticket); }
    [[nodiscard]] std::vector<ImageLoader::Loaded> take() override { return loader_.take(); }
    [[nodiscard]] std::optional<ImageLoader::Progress> progress() const override {
        return loader_.progress();
    }
    void watch(std::vector<std::filesystem::path> files) override { watch_.watch(std::move(files)); }
    [[nodiscard]] std::vector<std::filesystem::path> changed() override { return watch_.changed(); }
    void askThumbnail(const std::filesystem::path& file, std::filesystem::file_time_type modified) override {
        thumbnails_.ask(file, modified);
    }
    [[nodiscard]] std::shared_ptr<const Image> thumbnail(const std::filesystem::path& file) const override {
        return thumbnails_.find(file);
    }
    bool receiveThumbnails() override { return thumbnails_.receive(); }
    void wait() const override {
        loader_.wait();
        thumbnails_.wait();
    }

private:
    ImageLoader loader_; // for images that the user opens
    Thumbnails thumbnails_;
    FileWatch watch_;
};

/// Reads synchronously; watches nothing and has no small pictures. For programs without a user.
class FilesAtOnce : public Files {
public:
    [[nodiscard]] Ticket load(std::filesystem::path path, Wanted wanted = Wanted::Texture) override;
    void cancel(Ticket ticket) override;
    [[nodiscard]] std::vector<ImageLoader::Loaded> take() override;
    [[nodiscard]] std::optional<ImageLoader::Progress> progress() const override { return std::nullopt; }
    void watch(std::vector<std::filesystem::path> /*files*/) override {}
    [[nodiscard]] std::vector<std::filesystem::path> changed() override { return {}; }
    void wait() const override {}

private:
    Ticket last_ = 0;
    std::vector<ImageLoader::Loaded> loaded_;
};

} // namespace texplorer::ui
