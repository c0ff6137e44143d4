#pragma once

#include "core/base/worker.h"
#include "core/image/image.h"
#include "core/reference/sampling/level_picture.h"
#include "core/texture/levels_worker.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace texplorer::ui {

/// What of the texels is shown.
enum class Channel : std::uint8_t { All, Red, Green, Blue, Alpha, Luminance };

/// How texels are made visible. Changes nothing of the scene.
struct TexelLook {
    Channel channel = Channel::All;
    float exposure = 0; ///< values times 2 to this
    float low = 0;      ///< the value that is shown as 0
    float high = 1;     ///< and as 1, above `low`

    bool operator==(const TexelLook&) const = default;
};

/// An Rgba8 image as the look shows it.
[[nodiscard]] Image lookedAt(const Image& texels, const TexelLook& look);

struct LevelPictureRequest {
    LevelsRequest levels;
    int level = 0;
    TexelLook look{};

    bool operator==(const LevelPictureRequest&) const = default;

    /// Whether the other one is about the same texels.
    [[nodiscard]] bool sameTexels(const LevelPictureRequest& other) const {
        return level == other.level && levels == other.levels;
    }
};

/// Makes the picture of a level and counts its texels, for a window that must not wait: a large level takes
/// seconds, which a thread of its own has. All functions are to be called from one thread.
class LevelPictures {
public:
    /// `wake` is called on that thread whenever there is a new answer.
    explicit LevelPictures(When when, std::function<void()> wake = {});

    struct Answer {
        LevelPictureRequest request;            ///< what it answers
        std::shared_ptr<const Image> texels{};  ///< themselves, Rgba8; nullptr: `problem` says why not
        std::shared_ptr<const Image> picture{}; ///< as the look shows them
        std::optional<reference::TexelStatistics> statistics{};
        std::string problem{}; ///< a sentence without its full stop
    };
    /// The newest answer: to this request, or to an earlier one until there is one; nullptr: none yet. The
    /// levels come from `source`, and go back to it.
    [[nodiscard]] std::shared_ptr<const Answer> answer(const LevelPictureRequest& request,
                                                       LevelsWorker& source);

    /// Nobody asks any more: gives up what is being made, and forgets the answer.
    void rest();

    /// Sleeps until what was asked last is answered.
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
    std::shared_ptr<const PreparedLevels> levels_; ///< of what is asked, until its texels are there
    std::shared_ptr<const Answer> newest_;
    Making worker_; // last: it ends before the rest does
};

} // namespace texplorer::ui
