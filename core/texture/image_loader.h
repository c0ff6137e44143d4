#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/anatomy.h"
#include "texplorer/image/image.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/mesh/mesh_file.h"
#include "texplorer/texture/image_budget.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace texplorer {

/// A file for users to examine, whether it can be decoded or not.
struct DissectedFile {
    Anatomy anatomy;
    Bytes bytes;               ///< its beginning, at most keptBytes
    std::size_t fileBytes = 0; ///< on disk
    Sentence problem;          ///< why it cannot be decoded; empty: it can

    static constexpr std::size_t keptBytes = std::size_t{8} << 20;
};

/// Dissects the content of a file.
[[nodiscard]] std::shared_ptr<const DissectedFile> dissectFile(Bytes bytes);

/// Reads and decodes files on a thread of its own, one after the other in the order of the calls. The caller
/// keeps the ticket and looks for its result in `take`. All functions must be called from one thread; the
/// first `load` starts the other.
class ImageLoader {
public:
    using Ticket = std::uint64_t; ///< never 0
    enum class Wanted {
        Texture,   ///< the whole content: a TextureImage, or a MeshFile of a file NAME.obj
        Thumbnail, ///< a small upright Image; refused for files above thumbnailFileBytes, or with many texels
        Anatomy,   ///< a DissectedFile
    };
    static constexpr int thumbnailExtent = 64;
    static constexpr std::size_t thumbnailFileBytes = std::size_t{64} << 20;

    using Content = std::variant<std::shared_ptr<const TextureImage>, Image,
                                 std::shared_ptr<const DissectedFile>, std::shared_ptr<const MeshFile>>;
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
        std::size_t fileBytes = 0; ///< 0: unknown yet
    };

    /// `wake` is called on the loading thread whenever `take` or `progress` has something new.
    explicit ImageLoader(std::function<void()> wake = {});
    ImageLoader(const ImageLoader&) = delete;
    ImageLoader& operator=(const ImageLoader&) = delete;
    /// Stops reading at once; waits for a file that is being decoded.
    ~ImageLoader();

    /// Starts loading. Loading a file twice reads it twice: it can have changed in between. Textures that
    /// were not taken count towards sceneImageBytes: one that would exceed it is refused.
    [[nodiscard]] Ticket load(std::filesystem::path path, Wanted wanted = Wanted::Texture);

    /// Drops the result. If the file is being decoded, the thread is busy until that is done.
    void cancel(Ticket ticket);

    /// Returns the finished results, in the order of the calls.
    [[nodiscard]] std::vector<Loaded> take();

    /// The current file, or the next one; empty: all is done.
    [[nodiscard]] std::optional<Progress> progress() const;

    /// Blocks until all results can be taken.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The same on the calling thread, within `left` of sceneImageBytes.
[[nodiscard]] Result<ImageLoader::Content>
loadNow(const std::filesystem::path& path, ImageLoader::Wanted wanted, std::size_t left = sceneImageBytes);

} // namespace texplorer
