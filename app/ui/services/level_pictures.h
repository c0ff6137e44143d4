#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/base/worker.h"
#include "texplorer/image/image.h"
#include "texplorer/reference/sampling/level_picture.h"
#include "texplorer/texture/levels_worker.h"

#include <functional>
#include <memory>
#include <optional>

namespace texplorer::ui {

/// The displayed channel of the texels.
enum class Channel : std::uint8_t { All, Red, Green, Blue, Alpha, Luminance };

/// How texels are displayed. Does not change the scene.
struct TexelLook {
    Channel channel = Channel::All;
    float exposure = 0; ///< values are multiplied by 2 to this power
    float low = 0;      ///< the value that is displayed as 0
    float high = 1;     ///< the value that is displayed as 1, above `low`

    bool operator==(const TexelLook&) const = default;
};

/// Converts an image to Rgba8 with the look applied.
[[nodiscard]] Image lookedAt(const Image& texels, const TexelLook& look);

struct LevelPictureRequest {
    LevelsRequest levels;
    int level = 0;
    TexelLook look{};

    bool operator==(const LevelPictureRequest&) const = default;

    /// Whether both requests use the same texels.
    [[nodiscard]] bool sameTexels(const LevelPictureRequest& other) const {
        return level == other.level && levels == other.levels;
    }
};

/// Makes the picture of a level and counts its texels, without blocking the window: a large level takes
/// seconds on a separate thread. Call all functions on one thread.
class LevelPictures {
public:
    /// `wake` is called on the separate thread when there is a new answer.
    explicit LevelPictures(When when, std::function<void()> wake = {});

    struct Answer {
        LevelPictureRequest request;            ///< the request that it answers
        std::shared_ptr<const Image> texels{};  ///< Rgba8; nullptr: see `problem`
        std::shared_ptr<const Image> picture{}; ///< the texels with the look applied
        std::optional<reference::TexelStatistics> statistics{};
        Sentence problem{}; ///< a sentence without its full stop
    };
    /// The newest answer: for this request, or for an earlier one until it is ready; nullptr: none yet.
    /// Levels are taken from `source` and returned to it.
    [[nodiscard]] std::shared_ptr<const Answer> answer(const LevelPictureRequest& request,
                                                       LevelsWorker& source);

    /// Call when the picture is no longer needed: cancels the work and frees the answer.
    void rest();

    /// Blocks until the last request is answered.
    void wait() const { worker_.wait(); }

private:
    struct Job {
        LevelPictureRequest request;
        std::shared_ptr<const PreparedLevels> levels; ///< nullptr: `known` has the texels
        std::shared_ptr<const Answer> known;
    };
    using Making = Worker<Job, std::shared_ptr<const Answer>>;
    [[nodiscard]] static std::shared_ptr<const Answer> make(const Making::Task& task);
    void take(LevelsWorker& source);

    std::optional<LevelPictureRequest> asked_;
    std::shared_ptr<const PreparedLevels> levels_; ///< for the current request, until its texels are ready
    std::shared_ptr<const Answer> newest_;
    Making worker_; // last member: it ends before the others
};

} // namespace texplorer::ui
