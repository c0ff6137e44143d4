#pragma once

#include "app/render/capabilities.h"
#include "app/render/gl_errors.h"
#include "app/render/texture_object.h"
#include "core/reference/sampling/sampled_texture.h"
#include "core/texture/levels_source.h"

#include <memory>
#include <optional>
#include <string_view>

namespace texplorer::render {

/// A texture object that follows what is wanted of it. It shows what it showed before until the next levels
/// are made and uploaded as a whole; with a LevelsSource that may take several frames.
class LiveTexture {
public:
    /// To be called once a frame, with GL's active unit free for its target. Without `source` levels are made
    /// and uploaded at once. `capabilities` (nullptr: as if it could do anything) decide what is refused or
    /// decompressed; GL errors and notes are reported as `where`.
    void follow(const LevelsRequest& request, const view::Capabilities* capabilities, LevelsSource* source,
                std::string_view where);

    /// Whether it is up to date: then `follow` has nothing to do.
    [[nodiscard]] bool shows(const LevelsRequest& request) const { return shown_ == request; }

    /// Empty where there is nothing to show.
    [[nodiscard]] TextureObject& object() { return object_; }
    [[nodiscard]] const TextureObject& object() const { return object_; }
    [[nodiscard]] int lastLevel() const { return lastLevel_; }
    [[nodiscard]] LateFlip lateFlip() const { return lateFlip_; }

    /// Whether texels may be below 0: those of a signed format.
    [[nodiscard]] bool hasNegative() const { return hasNegative_; }

    /// Its base format and the extents of its levels, without texels: enough to say whether it is complete.
    [[nodiscard]] const reference::SampledTexture& shape() const { return shape_; }

    /// What there is to say of it: the same sentences with every frame, for as long as it is like this.
    [[nodiscard]] const GlErrors& errors() const { return cancelled_ ? cancelledErrors_ : errors_; }

    /// Whether what is wanted was given up, so that it shows what it showed before.
    [[nodiscard]] bool isCancelled() const { return cancelled_; }

    /// Whether an upload has to go on with the next frame.
    [[nodiscard]] bool isUploading() const { return next_.has_value() || given_.has_value(); }

private:
    /// Levels that are uploaded, until their source gets them back.
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
    void refuse(const LevelsRequest& request, std::string_view where, const std::string& sentence);
    void finish();
    void giveBack(LevelsSource* source);

    std::optional<LevelsRequest> shown_;
    TextureObject object_;
    int lastLevel_ = 1000;
    LateFlip lateFlip_ = LateFlip::None;
    bool hasNegative_ = false;
    reference::SampledTexture shape_;
    GlErrors errors_;
    bool cancelled_ = false;
    GlErrors cancelledErrors_; ///< instead of errors_, while it is
    std::optional<Next> next_;
    std::optional<Given> given_;
};

} // namespace texplorer::render
