#pragma once

// Where a renderer has a texture's levels from. Without a source it makes them itself and waits for them.

#include "core/texture/image_source.h"
#include "core/texture/texture_levels.h"

#include <memory>

namespace texplorer {

/// Which levels: of which images, with one texture's settings, for one target.
struct LevelsRequest {
    TexturePictures pictures; // held, so that no others can come to have these addresses
    Texture settings;         ///< those of imageSettings
    Target target = Target::Texture2D;

    bool operator==(const LevelsRequest&) const = default;
};

using PreparedLevels = Result<TextureLevels>;

/// What lets a window stay live while levels are made. To be called from the renderer's thread.
class LevelsSource {
public:
    LevelsSource() = default;
    LevelsSource(const LevelsSource&) = delete;
    LevelsSource& operator=(const LevelsSource&) = delete;
    virtual ~LevelsSource() = default;

    /// The levels, or the error of prepareLevels; nullptr: not yet, ask again with the next frame. What is
    /// not asked for in a frame is given up. An error of ErrorCode::Cancelled means that the user doesn't
    /// want to wait.
    [[nodiscard]] virtual std::shared_ptr<const PreparedLevels> prepare(const LevelsRequest& request) = 0;

    /// Whether a user waits: then an upload may take several frames.
    [[nodiscard]] virtual bool isLive() const = 0;

    /// The levels are uploaded: they are given back, because to free so much memory takes its time, too.
    /// `made`: what the driver holds, where it was asked to compress them; else empty.
    virtual void uploaded(const LevelsRequest& request, std::shared_ptr<const PreparedLevels> levels,
                          std::vector<TextureLevel> made) = 0;
};

} // namespace texplorer
