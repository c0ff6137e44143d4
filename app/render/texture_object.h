#pragma once

#include "app/render/gl_errors.h"
#include "app/render/gl_handle.h"
#include "core/scene/scene.h"
#include "core/texture/texture_levels.h"

#include <optional>
#include <string_view>

namespace texplorer::render {

/// How far an upload has got.
struct UploadCursor {
    std::size_t level = 0; ///< index of the next one
    int row = 0;           ///< the next one of it; the next slice for a volume
};

/// A GL texture object: images that never change, and parameters that follow a Texture of the scene.
class TextureObject {
public:
    TextureObject() = default;

    /// One without levels yet, for `upload`.
    explicit TextureObject(Target target);

    /// Uploads every level to a new texture object: blocks as they are, pixels with the bits of the levels'
    /// internal format, or compressed by the driver where the levels ask for it. GL errors are reported as
    /// `where`.
    TextureObject(Target target, const TextureLevels& levels, std::string_view where, GlErrors& errors);

    /// Uploads about `bytes` more of the levels; driver's compression counts for its slowness. True where all
    /// are there. `levels` must be the same with every call.
    [[nodiscard]] bool upload(const TextureLevels& levels, UploadCursor& cursor, std::size_t bytes,
                              std::string_view where, GlErrors& errors);

    /// The one place where a Texture becomes glTexParameter calls; none where nothing changed. What GL
    /// refused is reported every time.
    void apply(const Texture& texture, float maxAnisotropy, std::string_view where, GlErrors& errors);

    [[nodiscard]] GLuint name() const { return handle_.name(); }

    /// The levels as the driver holds them: blocks where they are compressed, Depth32 of depths, else Rgba8;
    /// those that are missing are left out. Binds the texture.
    [[nodiscard]] Result<std::vector<TextureLevel>> read() const;

private:
    TextureHandle handle_;
    GLenum target_ = GL_TEXTURE_2D;
    std::optional<Texture> applied_;
    GlErrors applyErrors_;
};

} // namespace texplorer::render
