#pragma once

#include "app/ui/model/thumbnails.h"
#include "core/base/file_watch.h"
#include "core/texture/image_loader.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texplorer::ui {

/// Reads files for the window. What is asked for has a ticket, and is there to be taken later: how much
/// later is the implementation's. All functions are called from one thread.
class Files {
public:
    using Ticket = ImageLoader::Ticket;
    using Wanted = ImageLoader::Wanted;

    Files() = default;
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;
    virtual ~Files() = default;

    [[nodiscard]] virtual Ticket load(std::filesystem::path path, Wanted wanted = Wanted::Texture) = 0;
    /// From here on nothing comes of it.
    virtual void cancel(Ticket ticket) = 0;
    /// What is finished, in the order in which it was asked for.
    [[nodiscard]] virtual std::vector<ImageLoader::Loaded> take() = 0;
    /// The file that is worked on; nothing: all is done.
    [[nodiscard]] virtual std::optional<ImageLoader::Progress> progress() const = 0;

    /// Looks out for changes of exactly these files from now on.
    virtual void watch(std::vector<std::filesystem::path> files) = 0;
    /// Those that have changed since the last call.
    [[nodiscard]] virtual std::vector<std::filesystem::path> changed() = 0;

    /// A small picture of a file; nullptr: not there yet, or none can be had. `modified` tells a changed file
    /// from what it was.
    [[nodiscard]] virtual std::shared_ptr<const Image>
    thumbnail(const std::filesystem::path& file, std::filesystem::file_time_type modified) = 0;
    /// To be called once before each frame. True where a small picture has come.
    virtual bool receiveThumbnails() = 0;

    /// Sleeps until everything that was asked for is there to be taken.
    virtual void wait() const = 0;
};

/// Reads on threads of its own; `wake` is called on those when there is news.
class FilesBeside final : public Files {
public:
    explicit FilesBeside(const std::function<void()>& wake = {});

    [[nodiscard]] Ticket load(std::filesystem::path path, Wanted wanted = Wanted::Texture) override;
    void cancel(Ticket ticket) override;
    [[nodiscard]] std::vector<ImageLoader::Loaded> take() override;
    [[nodiscard]] std::optional<ImageLoader::Progress> progress() const override;
    void watch(std::vector<std::filesystem::path> files) override;
    [[nodiscard]] std::vector<std::filesystem::path> changed() override;
    [[nodiscard]] std::shared_ptr<const Image> thumbnail(const std::filesystem::path& file,
                                                         std::filesystem::file_time_type modified) override;
    bool receiveThumbnails() override;
    void wait() const override;

private:
    ImageLoader loader_; // what the user wants to see
    Thumbnails thumbnails_;
    FileWatch watch_;
};

/// Reads while one waits; watches nothing and has no small pictures. For programs without a user.
class FilesAtOnce final : public Files {
public:
    [[nodiscard]] Ticket load(std::filesystem::path path, Wanted wanted = Wanted::Texture) override;
    void cancel(Ticket ticket) override;
    [[nodiscard]] std::vector<ImageLoader::Loaded> take() override;
    [[nodiscard]] std::optional<ImageLoader::Progress> progress() const override { return std::nullopt; }
    void watch(std::vector<std::filesystem::path> /*files*/) override {}
    [[nodiscard]] std::vector<std::filesystem::path> changed() override { return {}; }
    [[nodiscard]] std::shared_ptr<const Image>
    thumbnail(const std::filesystem::path& /*file*/, std::filesystem::file_time_type /*modified*/) override {
        return nullptr;
    }
    bool receiveThumbnails() override { return false; }
    void wait() const override {}

private:
    Ticket last_ = 0;
    std::vector<ImageLoader::Loaded> loaded_;
};

} // namespace texplorer::ui
