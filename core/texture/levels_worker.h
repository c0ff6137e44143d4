#pragma once

#include "core/base/worker.h"
#include "core/image/image.h"
#include "core/texture/levels_source.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer {

/// What there is to say of a texture's levels.
struct LevelsSummary {
    TextureReport report;
    std::optional<BlockFormat> compressed; ///< the format of the blocks; none: pixels
    bool byDriver = false;                 ///< the driver compresses: what it lost is known once it has
    std::vector<std::string> notes;        ///< sentences: what was done otherwise than asked for, and why
    std::string problem;                   ///< why there are no levels; empty: there are
    /// Small upright pictures, at most thumbnailExtent texels a side: of the image before its preparation and
    /// after each step; empty where there is none.
    std::vector<std::shared_ptr<const Image>> steps;
    /// The same of levels that are given one by one: of those that there are, each with its number.
    std::vector<std::pair<int, std::shared_ptr<const Image>>> pictures;

    /// Of each level, upright, of a cube map its first face: texel by texel up to levelExtent a side, what is
    /// larger reduced to that.
    std::vector<std::pair<int, std::shared_ptr<const Image>>> levels;
    /// The same of the other faces of a cube map, from -x on.
    std::array<std::vector<std::pair<int, std::shared_ptr<const Image>>>, 5> otherFaces;

    static constexpr int thumbnailExtent = 64;
    static constexpr int levelExtent = 256;
};

/// Whether levels are made in a few milliseconds.
[[nodiscard]] bool isQuick(const LevelsRequest& request);

/// Makes levels: small ones while one waits, large ones on a thread of its own, one after the other. All
/// functions are to be called from one thread; the first long work starts the other one.
class LevelsWorker final : public LevelsSource {
public:
    using When = texplorer::When; ///< WhenReady: a caller who asks for something large is told to ask again

    /// `wake` is called on the working thread whenever `receive` or `progress` has something new to say.
    /// What is compressed at run time is looked for and kept in `work.cache`; `work.progress` and `work.stop`
    /// are for AtOnce.
    explicit LevelsWorker(When when, std::function<void()> wake = {}, LevelWork work = {});
    LevelsWorker(const LevelsWorker&) = delete;
    LevelsWorker& operator=(const LevelsWorker&) = delete;
    /// Waits for what is being made; asks it to stop before.
    ~LevelsWorker() override;

    [[nodiscard]] std::shared_ptr<const PreparedLevels> prepare(const LevelsRequest& request) override;
    [[nodiscard]] bool isLive() const override;
    void uploaded(const LevelsRequest& request, std::shared_ptr<const PreparedLevels> levels,
                  std::vector<TextureLevel> made) override;

    /// The numbers, as far as they are known; nullptr: not yet. Makes the levels where nobody has.
    [[nodiscard]] std::shared_ptr<const LevelsSummary> summary(const LevelsRequest& request);

    /// To be called once before each frame. True where something new can be shown.
    bool receive();

    using Ticket = std::uint64_t; ///< never 0
    struct Progress {
        Ticket ticket = 0;
        std::string what; ///< the name of the image
        float done = 0;   ///< 0 to 1, of what is compressed at run time
    };
    /// What is being made; nothing: all is done. What is only being measured isn't mentioned.
    [[nodiscard]] std::optional<Progress> progress() const;

    /// Gives levels up: `prepare` answers Cancelled until `retry`.
    void cancel(Ticket ticket);
    /// Forgets that these levels were given up.
    void retry(const LevelsRequest& request);
    [[nodiscard]] bool isCancelled(const LevelsRequest& request) const;

    /// Sleeps until everything that was asked for can be received.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer
