#pragma once

#include "app/ui/model/session.h"
#include "app/ui/services/level_pictures.h"

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
    ChannelRow{Channel::All, "RGBA", N_("Colour"), N_("The unchanged texels")},
    ChannelRow{Channel::Red, "R", N_("Red"), N_("Red only, as grey")},
    ChannelRow{Channel::Green, "G", N_("Green"), N_("Green only, as grey")},
    ChannelRow{Channel::Blue, "B", N_("Blue"), N_("Blue only, as grey")},
    ChannelRow{Channel::Alpha, "A", N_("Alpha"), N_("Alpha only: black is transparent, white is opaque")},
    ChannelRow{Channel::Luminance, "L", N_("Luminance"),
               N_("The luminance of the texels: 0.2126 R + 0.7152 G + 0.0722 B")},
};

/// How the panel shows the texture's picture. Does not change the scene.
struct PlaneLook : TexelLook {
    int level = 0;     ///< of the mip levels
    bool board = true; ///< transparent parts show a checkerboard; else their colour

    static constexpr float maxExposure = 8;

    /// Whether the unchanged texels of the base level are shown.
    [[nodiscard]] bool isPlain() const {
        return level == 0 && static_cast<const TexelLook&>(*this) == TexelLook{};
    }
};

/// The picture of a level of the bound texture, with its statistics, for looks that the host's picture of the
/// base level does not support.
class LevelPicture {
public:
    /// Call in every frame; makes nothing unless it is `needed`. `look` must live as long as the picture.
    void follow(const Session& session, const PlaneLook& look, bool needed);

    /// The picture with the look, or with the previous one while the new picture is being made; nullptr: not
    /// needed, or not ready.
    [[nodiscard]] std::shared_ptr<const Image> picture() const {
        return answer_ ? answer_->picture : nullptr;
    }
    [[nodiscard]] const reference::TexelStatistics* statistics() const {
        return answer_ && answer_->statistics ? &*answer_->statistics : nullptr;
    }
    /// Why there is no picture, as a sentence without its full stop; empty: there is one, or it is pending.
    [[nodiscard]] const Sentence& problem() const;
    /// Whether the shown picture is not the requested one yet.
    [[nodiscard]] bool isComputing() const { return computing_; }

private:
    std::shared_ptr<const LevelPictures::Answer> answer_;
    bool computing_ = false;
};

/// The bound texture's levels; empty if not known yet.
[[nodiscard]] std::vector<LevelReport> levelsOfBound(const Session& session);

/// The extent of a level of the bound texture, its first one by default, as passed to OpenGL, without a
/// border: width, height and depth. None: not known yet, or there is no such level.
[[nodiscard]] std::optional<glm::ivec3> extentOfBound(const Session& session, std::optional<int> level = {});

} // namespace texplorer::ui
