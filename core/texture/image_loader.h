#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/anatomy.h"
#include "core/image/image.h"
#include "core/image/texture_image.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace texplorer {

/// A file for people to look into, whether it can be decoded or not.
struct DissectedFile {
    Anatomy anatomy;
    Bytes bytes;               ///< the beginning, at most keptBytes
    std::size_t fileBytes = 0; ///< as it lies on the disk
    std::string problem;       ///< why it can't be decoded; empty: it can

    static constexpr std::size_t keptBytes = std::size_t{8} << 20;
};

/// Of a file's content that is there.
[[nodiscard]] std::shared_ptr<const DissectedFile> dissectFile(Bytes bytes);

/// Reads files and makes pictures of them on a thread of its own, one after the other in the order in which
/// they were asked for. The caller keeps the ticket and looks for its result in `take`. All functions are
/// to be called from one thread; the first `load` starts the other one.
class ImageLoader {
public:
    using Ticket = std::uint64_t; ///< never 0
    enum class Wanted {
        Texture,   ///< everything that the file holds: a TextureImage
        Thumbnail, ///< a small upright Image; a file over thumbnailFileBytes, or of many texels, is refused
        Anatomy,   ///< a DissectedFile
    };
    static constexpr int thumbnailExtent = 64;
    static constexpr std::size_t thumbnailFileBytes = std::size_t{64} << 20;

    using Content =
        std::variant<std::shared_ptr<const TextureImage>, Image, std::shared_ptr<const DissectedFile>>;
    struct Loaded {
        Ticket ticket = 0;
        std::filesystem::path path;
        Result<Content> content; ///< an error's `where` is the path
    };

    enum class Step { Waiting, Reading, Decoding };
    struct Progress {
        Ticket ticket = 0;
        std::filesystem::path path;
        Step step = Step::Waiting;
        std::size_t bytesRead = 0;
        std::size_t fileBytes = 0; ///< 0: not known yet
    };

    /// `wake` is called on the loading thread whenever `take` or `progress` has something new to say.
    explicit ImageLoader(std::function<void()> wake = {});
    ImageLoader(const ImageLoader&) = delete;
    ImageLoader& operator=(const ImageLoader&) = delete;
    /// Stops reading at once; a file that is being decoded is waited for.
    ~ImageLoader();

    /// The same file twice is read twice: it may have changed in between. Textures that nobody takes are as
    /// many as a scene may have: one that would exceed sceneImageBytes with them is refused.
    [[nodiscard]] Ticket load(std::filesystem::path path, Wanted wanted = Wanted::Texture);

    /// From here on nothing comes of it. A file that is being decoded keeps the thread busy until it is done.
    void cancel(Ticket ticket);

    /// What is finished, in the order in which it was asked for.
    [[nodiscard]] std::vector<Loaded> take();

    /// The file that is worked on, or the next one that waits; nothing: all is done.
    [[nodiscard]] std::optional<Progress> progress() const;

    /// Sleeps until everything that was asked for is there to be taken.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The same on the thread that calls.
[[nodiscard]] Result<ImageLoader::Content> loadNow(const std::filesystem::path& path,
                                                   ImageLoader::Wanted wanted);

} // namespace texplorer
