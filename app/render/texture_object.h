#pragma once

#include "app/render/gl_errors.h"
#include "app/render/gl_handle.h"
#include "app/view/stored_texture.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/texture_levels.h"

#include <optional>
#include <string_view>

namespace texplorer::render {

/// The progress of an upload.
struct UploadCursor {
    std::size_t level = 0; ///< index of the next level
    int row = 0;           ///< its next row; the next slice of a volume
};

/// A GL texture object: its images never change, its parameters follow a Texture of the scene.
class TextureObject {
public:
    TextureObject() = default;

    /// Creates one without levels, for `upload`.
    explicit TextureObject(Target target);

    /// Uploads every level to a new texture object: blocks unchanged, pixels with the precision of the
    /// levels' internal format, or compressed by the driver if the levels request it. With `madeByDriver`
    /// only the base is uploaded, and glGenerateMipmap makes the rest. GL errors are reported as `where`.
    TextureObject(Target target, const TextureLevels& levels, std::string_view where, GlErrors& errors);

    /// Uploads about `bytes` more of the levels; compression by the driver counts more. Returns true when all
    /// are uploaded. `levels` must be the same with every call.
    [[nodiscard]] bool upload(const TextureLevels& levels, UploadCursor& cursor, std::size_t bytes,
                              std::string_view where, GlErrors& errors);

    /// The only place that turns a Texture into glTexParameter calls; makes none if nothing changed. Calls
    /// that GL refused are reported every time.
    void apply(const Texture& texture, float maxAnisotropy, std::string_view where, GlErrors& errors);

    [[nodiscard]] GLuint name() const { return handle_.name(); }

    /// The levels as the driver holds them: blocks if they are compressed, Depth32 for depths, RgbaFloat for
    /// floats, else Rgba8; missing levels are left out. Binds the texture.
    [[nodiscard]] Result<std::vector<TextureLevel>> read() const;

    /// What OpenGL says of the levels. Binds the texture.
    [[nodiscard]] view::StoredTexture stored() const;

private:
    TextureHandle handle_;
    GLenum target_ = GL_TEXTURE_2D;
    std::optional<Texture> applied_;
    GlErrors applyErrors_;
};

} // namespace texplorer::render
