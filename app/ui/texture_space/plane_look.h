#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "core/reference/sampling/level_picture.h"
#include "core/texture/levels_source.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace texplorer::ui {

/// What of the texels is shown.
enum class Channel : std::uint8_t { All, Red, Green, Blue, Alpha, Luminance };

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
struct PlaneLook {
    Channel channel = Channel::All;
    float exposure = 0; ///< values times 2 to this
    float low = 0;      ///< the value that is shown as 0
    float high = 1;     ///< and as 1, above `low`
    int level = 0;      ///< of the mip levels
    bool board = true;  ///< what is transparent shows a checkerboard; else its colour

    static constexpr float mostExposure = 8;

    /// Whether texels are shown as they are.
    [[nodiscard]] bool isPlain() const {
        return channel == Channel::All && exposure == 0 && low == 0 && high == 1;
    }
};

/// An Rgba8 image as the look shows it.
[[nodiscard]] Image lookedAt(const Image& texels, const PlaneLook& look);

/// The picture of a level of the bound texture, with its numbers, for a look that needs more than the host's
/// picture of the base level. Keeps what it made.
class LevelPicture {
public:
    /// To be called in every frame; makes nothing unless it is `needed`.
    void follow(Session& session, const PlaneLook& look, bool needed);

    /// As the look shows it; nullptr: not needed, or not there yet.
    [[nodiscard]] const std::shared_ptr<const Image>& picture() const { return picture_; }
    /// The texels themselves.
    [[nodiscard]] const std::shared_ptr<const Image>& texels() const { return texels_; }
    [[nodiscard]] const reference::TexelStatistics* statistics() const {
        return statistics_ ? &*statistics_ : nullptr;
    }
    /// Why there is no picture, as a sentence without its full stop; empty: there is, or will be.
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    std::optional<LevelsRequest> request_;
    int level_ = 0;
    std::shared_ptr<const Image> texels_;
    std::optional<reference::TexelStatistics> statistics_;
    std::string problem_;
    std::shared_ptr<const Image> picture_;
    std::shared_ptr<const Image> lookedAt_; ///< what picture_ was made of
    PlaneLook look_;
};

/// The numbers of the levels that the bound texture has; empty where that isn't known yet.
[[nodiscard]] std::vector<int> levelsOfBound(Session& session);

} // namespace texplorer::ui
