#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/base/worker.h"
#include "texplorer/image/image.h"
#include "texplorer/texture/levels_source.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer {

/// Facts about a texture's levels, for users.
struct LevelsSummary {
    TextureReport report;
    std::optional<BlockFormat> compressed; ///< the format of the blocks; empty: pixels
    bool byDriver = false;                 ///< the driver compresses: the loss is known only afterwards
    std::vector<Sentence> notes; ///< sentences about what was done differently than specified, and why
    Sentence problem;            ///< why there are no levels; empty: there are
    /// Small upright pictures, at most thumbnailExtent texels per side: the image before its preparation and
    /// after each step; empty without a preparation.
    std::vector<std::shared_ptr<const Image>> steps;
    /// The same for levels with their own images: the existing ones, with their numbers.
    std::vector<std::pair<int, std::shared_ptr<const Image>>> pictures;

    /// Each level, upright; of a cube map the first face: texel by texel up to levelExtent per side, larger
    /// ones reduced to that.
    std::vector<std::pair<int, std::shared_ptr<const Image>>> levels;
    /// The same for the other faces of a cube map, from -x on.
    std::array<std::vector<std::pair<int, std::shared_ptr<const Image>>>, 5> otherFaces;

    static constexpr int thumbnailExtent = 64;
    static constexpr int levelExtent = 256;
};

/// Whether levels can be made in a few milliseconds.
[[nodiscard]] bool isQuick(const LevelsRequest& request);

/// Makes levels: small ones immediately, large ones on a thread of its own, one after the other. All
/// functions must be called from one thread; the first long job starts the other.
class LevelsWorker final : public LevelsSource {
public:
    using When = texplorer::When; ///< WhenReady: callers must call again for large levels

    /// `wake` is called on the working thread whenever `receive` or `progress` has something new. Compressed
    /// levels are stored in `work.cache`; `work.progress` and `work.stop` are for AtOnce.
    explicit LevelsWorker(When when, std::function<void()> wake = {}, LevelWork work = {});
    LevelsWorker(const LevelsWorker&) = delete;
    LevelsWorker& operator=(const LevelsWorker&) = delete;
    /// Requests a stop of the current job and waits for it.
    ~LevelsWorker() override;

    [[nodiscard]] std::shared_ptr<const PreparedLevels> prepare(const LevelsRequest& request) override;
    [[nodiscard]] bool isLive() const override;
    void uploaded(const LevelsRequest& request, std::shared_ptr<const PreparedLevels> levels,
                  std::vector<TextureLevel> made) override;

    /// The facts that are known so far; nullptr: none yet. Makes the levels if needed.
    [[nodiscard]] std::shared_ptr<const LevelsSummary> summary(const LevelsRequest& request);
    /// The same, but makes nothing.
    [[nodiscard]] std::shared_ptr<const LevelsSummary> find(const LevelsRequest& request) const;

    /// Call once before each frame. Returns whether something new can be shown.
    bool receive();

    using Ticket = std::uint64_t; ///< never 0
    struct Progress {
        Ticket ticket = 0;
        Sentence what;  ///< the image's name
        float done = 0; ///< 0 to 1, for compression at run time
    };
    /// The current job; empty: all is done. Jobs that only measure are not reported.
    [[nodiscard]] std::optional<Progress> progress() const;

    /// Cancels levels: `prepare` returns Cancelled until `retry`.
    void cancel(Ticket ticket);
    /// Undoes the cancellation of these levels.
    void retry(const LevelsRequest& request);
    [[nodiscard]] bool isCancelled(const LevelsRequest& request) const;

    /// Blocks until all results can be received.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer
