#pragma once

#include "core/base/worker.h"
#include "core/image/image.h"

#include <glm/vec4.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace texplorer::ui {

/// Draws a small image with every environment mode and base format, for a window that must not wait: see
/// reference::environmentPictures. All functions are to be called from one thread.
class EnvironmentPictures {
public:
    /// `wake` is called on the thread that works whenever there are new pictures.
    explicit EnvironmentPictures(When when, std::function<void()> wake = {});

    struct Question {
        std::shared_ptr<const Image> texels{}; ///< Rgba8; nullptr: every hue with every alpha
        glm::vec4 fragment{1};
        glm::vec4 constant{0};

        bool operator==(const Question&) const = default;
    };
    /// The newest ones, all in one image: to this question, or to an earlier one until there are those.
    /// nullptr: none yet.
    [[nodiscard]] std::shared_ptr<const Image> find(const Question& question);

    /// Nobody looks any more.
    void rest();

    /// A picture's longer side has no more texels.
    static constexpr int longest = 48;

private:
    std::optional<Question> asked_;
    std::shared_ptr<const Image> newest_;
    Worker<Question, std::shared_ptr<const Image>> worker_; // last: it ends before the rest does
};

} // namespace texplorer::ui
