#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/image/image.h"

#include <optional>
#include <vector>

namespace texplorer::animation {

/// The settings of an animation.
struct Settings {
    int width = 1;
    int height = 1;
    int plays = 0;                    ///< number of times that it is shown; 0: endless
    int unitsPerSecond = 1000;        ///< units of durations, per second
    std::optional<float> quality{};   ///< WebP: 0 to 100, lossy; empty: lossless
    std::vector<PictureText> texts{}; ///< APNG: written before the pixels
};

/// Encodes pictures one by one and returns the file's bytes. It stores one or two pictures in addition to the
/// output. Not thread-safe.
class Encoder {
public:
    Encoder() = default;
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    virtual ~Encoder() = default;

    /// Adds an Rgba8 or Rgb8 image of the animation's size; its alpha is ignored. `duration` is in units,
    /// from 1 to the format's maximum. Error: TooLarge where the file would exceed the format's limit or the
    /// memory.
    [[nodiscard]] virtual Result<void> add(const Image& picture, int duration) = 0;

    /// Returns the whole file. Call it once, after at least one picture was added.
    [[nodiscard]] virtual Result<Bytes> finish() = 0;
};

/// The largest file that an encoder makes: the file is in memory until it is written.
inline constexpr std::size_t maxAnimationBytes = std::size_t{1} << 30;

} // namespace texplorer::animation
