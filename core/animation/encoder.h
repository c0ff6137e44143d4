#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/common/write_options.h"
#include "core/image/image.h"

#include <optional>
#include <vector>

namespace texplorer::animation {

/// What an animation is, all but its pictures.
struct Settings {
    int width = 1;
    int height = 1;
    int plays = 0;                    ///< how often it is shown; 0: for ever
    int unitsPerSecond = 1000;        ///< in which durations are
    std::optional<float> quality{};   ///< WebP: 0 to 100, with losses; none: without any
    std::vector<PictureText> texts{}; ///< APNG, in front of the pixels
};

/// Pictures in, one after the other, the file's bytes out. It keeps a picture or two beside what it has
/// written. Used on one thread at a time.
class Encoder {
public:
    Encoder() = default;
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    virtual ~Encoder() = default;

    /// An Rgba8 or Rgb8 image of the animation's size, shown as if it were opaque; `duration` in units, from
    /// 1 to the format's most. Errors: TooLarge where the file would become larger than the format or memory
    /// has room for.
    [[nodiscard]] virtual Result<void> add(const Image& picture, int duration) = 0;

    /// The whole file, once, behind at least one picture.
    [[nodiscard]] virtual Result<Bytes> finish() = 0;
};

/// The largest file that an encoder makes: all of it is in memory until it is written.
inline constexpr std::size_t mostAnimationBytes = std::size_t{1} << 30;

} // namespace texplorer::animation
