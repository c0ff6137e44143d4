#pragma once

#include "app/render/capabilities.h"
#include "app/render/gl_errors.h"
#include "app/render/texture_object.h"
#include "texplorer/reference/sampling/sampled_texture.h"
#include "texplorer/texture/levels_source.h"

#include <memory>
#include <optional>
#include <string_view>

namespace texplorer::render {

/// A texture object that follows the requested levels. Shows the previous ones until the next ones are made
/// and fully uploaded; with a LevelsSource that can take several frames.
class LiveTexture {
public:
    /// Call once per frame; GL's active unit must be free for its target. Without `source` levels are made
    /// and uploaded at once. `capabilities` decide what is refused or decompressed (nullptr: no limits). GL
    /// errors and notes are reported as `where`.
    void follow(const LevelsRequest& request, const view::Capabilities* capabilities, LevelsSource* source,
                std::string_view where);

    /// Whether it is up to date, so that `follow` would do nothing.
    [[nodiscard]] bool shows(const LevelsRequest& request) const { return shown_ == request; }

    /// Empty if there is nothing to show.
    [[nodiscard]] TextureObject& object() { return object_; }
    [[nodiscard]] const TextureObject& object() const { return object_; }
    [[nodiscard]] int lastLevel() const { return lastLevel_; }
    [[nodiscard]] LateFlip lateFlip() const { return lateFlip_; }

    /// Whether texels may lie outside 0 … 1: those of floats and of signed blocks.
    [[nodiscard]] bool isUnclamped() const { return isUnclamped_; }

    /// The base format and the extents of the levels, without texels: enough to check completeness.
    [[nodiscard]] const reference::SampledTexture& shape() const { return shape_; }

    /// What the driver stores; nullptr: nothing is shown.
    [[nodiscard]] const std::shared_ptr<const view::StoredTexture>& stored() const { return stored_; }

    /// Errors and notes about its current state; repeated each frame while they apply.
    [[nodiscard]] const GlErrors& errors() const { return cancelled_ ? cancelledErrors_ : errors_; }

    /// Whether the request was cancelled, so that it still shows the previous levels.
    [[nodiscard]] bool isCancelled() const { return cancelled_; }

    /// Whether an upload continues in the next frame.
    [[nodiscard]] bool isUploading() const { return next_.has_value() || given_.has_value(); }

private:
    /// Uploaded levels, until they are returned to their source.
    struct Given {
        LevelsRequest request;
        std::shared_ptr<const PreparedLevels> levels;
    };
    struct Next {
        LevelsRequest request;
        std::shared_ptr<const PreparedLevels> levels;
        TextureObject object;
        UploadCursor cursor;
        GlErrors errors;
    };

    void begin(const LevelsRequest& request, std::shared_ptr<const PreparedLevels> levels,
               const view::Capabilities* capabilities, std::string_view where);
    void refuse(const LevelsRequest& request, std::string_view where, const Sentence& sentence);
    void finish();
    void giveBack(LevelsSource* source);

    std::optional<LevelsRequest> shown_;
    TextureObject object_;
    int lastLevel_ = 1000;
    LateFlip lateFlip_ = LateFlip::None;
    bool isUnclamped_ = false;
    reference::SampledTexture shape_;
    std::shared_ptr<const view::StoredTexture> stored_;
    GlErrors errors_;
    bool cancelled_ = false;
    GlErrors cancelledErrors_; ///< used instead of errors_ while it is cancelled
    std::optional<Next> next_;
    std::optional<Given> given_;
};

} // namespace texplorer::render
