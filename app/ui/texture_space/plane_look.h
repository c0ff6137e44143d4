#pragma once

#include "app/ui/model/level_pictures.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <glm/vec3.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

struct ChannelRow {
    Channel channel;
    const char* brief; ///< on its button
    const char* label;
    const char* help;
};

inline constexpr std::array channelRows{
    ChannelRow{Channel::All, "RGBA", "Colour", "The texels as they are"},
    ChannelRow{Channel::Red, "R", "Red", "Red alone, as grey"},
    ChannelRow{Channel::Green, "G", "Green", "Green alone, as grey"},
    ChannelRow{Channel::Blue, "B", "Blue", "Blue alone, as grey"},
    ChannelRow{Channel::Alpha, "A", "Alpha", "Alpha alone: black is transparent, white opaque"},
    ChannelRow{Channel::Luminance, "L", "Luminance",
               "How bright the texels are: 0.2126 R + 0.7152 G + 0.0722 B"},
};

/// How the panel shows the texture's picture. Changes nothing of the scene.
struct PlaneLook : TexelLook {
    int level = 0;     ///< of the mip levels
    bool board = true; ///< what is transparent shows a checkerboard; else its colour

    static constexpr float mostExposure = 8;

    /// Whether texels are shown as they are.
    [[nodiscard]] bool isPlain() const { return static_cast<const TexelLook&>(*this) == TexelLook{}; }
};

/// The picture of a level of the bound texture, with its numbers, for a look that needs more than the host's
/// picture of the base level.
class LevelPicture {
public:
    /// To be called in every frame; has nothing made unless it is `needed`.
    void follow(Session& session, const PlaneLook& look, bool needed);

    /// As the look shows it, or as the one before did while the new picture is being made; nullptr: not
    /// needed, or not there yet.
    [[nodiscard]] std::shared_ptr<const Image> picture() const {
        return answer_ ? answer_->picture : nullptr;
    }
    [[nodiscard]] const reference::TexelStatistics* statistics() const {
        return answer_ && answer_->statistics ? &*answer_->statistics : nullptr;
    }
    /// Why there is no picture, as a sentence without its full stop; empty: there is, or will be.
    [[nodiscard]] const std::string& problem() const;
    /// Whether what is shown isn't yet what was asked for.
    [[nodiscard]] bool isComputing() const { return computing_; }

private:
    std::shared_ptr<const LevelPictures::Answer> answer_;
    bool computing_ = false;
};

/// The numbers of the levels that the bound texture has; empty where that isn't known yet.
[[nodiscard]] std::vector<int> levelsOfBound(Session& session);

/// The texels of the bound texture's first level as OpenGL is given it, without a border: width, height and
/// depth. None: that isn't known yet, or there are none.
[[nodiscard]] std::optional<glm::ivec3> firstExtentOfBound(const Session& session);

} // namespace texplorer::ui
