#pragma once

// Where a renderer gets a texture's levels. Without a source, it makes them itself and blocks.

#include "texplorer/texture/image_source.h"
#include "texplorer/texture/texture_levels.h"

#include <memory>

namespace texplorer {

/// Levels of images, with one texture's settings, for one target.
struct LevelsRequest {
    TexturePictures pictures; // held, so that their addresses are not reused
    Texture settings;         ///< from imageSettings
    Target target = Target::Texture2D;

    bool operator==(const LevelsRequest&) const = default;
};

using PreparedLevels = Result<TextureLevels>;

/// Keeps a window responsive while levels are made. Called on the renderer's thread.
class LevelsSource {
public:
    LevelsSource() = default;
    LevelsSource(const LevelsSource&) = delete;
    LevelsSource& operator=(const LevelsSource&) = delete;
    virtual ~LevelsSource() = default;

    /// Returns the levels, or the error of prepareLevels; nullptr: not ready, call again in the next frame.
    /// Levels that are not requested in a frame are cancelled. ErrorCode::Cancelled means that the user
    /// cancelled them.
    [[nodiscard]] virtual std::shared_ptr<const PreparedLevels> prepare(const LevelsRequest& request) = 0;

    /// Whether a window is responsive meanwhile: then an upload may take several frames.
    [[nodiscard]] virtual bool isLive() const = 0;

    /// Called after the upload, to return the levels, as freeing much memory takes time, too. `made`: the
    /// result of the driver, if it was told to compress; else empty.
    virtual void uploaded(const LevelsRequest& request, std::shared_ptr<const PreparedLevels> levels,
                          std::vector<TextureLevel> made) = 0;
};

} // namespace texplorer
