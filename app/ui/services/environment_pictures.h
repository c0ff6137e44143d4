#pragma once

#include "app/ui/services/newest_answer.h"
#include "texplorer/image/image.h"

#include <glm/vec4.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace texplorer::ui {

/// Draws a small image with every environment mode and base format, without blocking the window: see
/// reference::environmentPictures. Call all functions on one thread.
class EnvironmentPictures {
public:
    /// `wake` is called on the working thread when there are new pictures.
    explicit EnvironmentPictures(When when, std::function<void()> wake = {});

    struct Question {
        std::shared_ptr<const Image> texels{}; ///< Rgba8; nullptr: every hue with every alpha
        glm::vec4 fragment{1};
        glm::vec4 constant{0};

        bool operator==(const Question&) const = default;
    };
    /// Call in every frame that shows the pictures. Returns true if new ones have arrived.
    bool ask(const Question& question);
    /// The newest pictures, all in one image: for the last question, or for an earlier one until they are
    /// ready. nullptr: none yet.
    [[nodiscard]] std::shared_ptr<const Image> newest() const { return newest_; }

    /// Call when the pictures are no longer shown.
    void rest();

    /// The maximum of a picture's longer side in texels.
    static constexpr int maxExtent = 48;

private:
    std::optional<Question> asked_;
    std::shared_ptr<const Image> newest_;
    NewestAnswer<Question, std::shared_ptr<const Image>> worker_; // last member: it ends before the others
};

} // namespace texplorer::ui
