#pragma once

#include "texplorer/base/result.h"
#include "texplorer/reference/draw_request.h"
#include "texplorer/scene/frame.h"
#include "texplorer/texture/texture_levels.h"

#include <memory>
#include <stop_token>

namespace texplorer::reference {

struct Kernel;      // see raster/kernel.h
struct Explanation; // see probe.h
struct PixelPlace;
struct Contributions; // see contributions.h
struct TexelQuestion;
struct LevelMap; // see level_map.h
struct LevelQuestion;

/// Options of the computation, which do not change the result.
struct DrawOptions {
    unsigned threads = 0; ///< 0: one per processor
    /// Draws each pixel on its own, with the simple functions of shade.h and sampler.h; many times slower.
    /// The result is the same: the tests compare both.
    bool literal = false;
    const Kernel* kernel = nullptr; ///< nullptr: the fastest that the processor supports
    LevelWork levels{};             ///< for textures that are compressed at run time
    std::stop_token stop{};

    /// Whether either token was stopped.
    [[nodiscard]] bool isStopped() const { return stop.stop_requested() || levels.stop.stop_requested(); }
};

/// The largest picture along each axis.
inline constexpr int maxPictureExtent = 16384;

/// Draws scenes on the processor as defined by the OpenGL 2.1 specification, without OpenGL. Caches the
/// textures of the last scene for the next picture. An object must be used by one thread at a time; it draws
/// with several threads of its own. Several objects, and the functions below, can be used by any number of
/// threads at once: scenes and images are only read.
class ReferenceRenderer {
public:
    ReferenceRenderer();
    ReferenceRenderer(ReferenceRenderer&&) noexcept;
    ReferenceRenderer& operator=(ReferenceRenderer&&) noexcept;
    ReferenceRenderer(const ReferenceRenderer&) = delete;
    ReferenceRenderer& operator=(const ReferenceRenderer&) = delete;
    ~ReferenceRenderer();

    /// Draws an Rgba8 image of the request's size. Errors: OutOfRange for a size below 1 or above
    /// maxPictureExtent, TooLarge without memory, Cancelled after a stop request.
    [[nodiscard]] Result<Frame> draw(const DrawRequest& request, const DrawOptions& options = {});

    /// Returns the request's images with those that are drawn for textures that units show: the light's view
    /// and pictures of passes. Errors: as `draw`.
    [[nodiscard]] Result<ImageSource> drawnImages(const DrawRequest& request,
                                                  const DrawOptions& options = {});

    /// Explains the colour of one pixel of that picture, without drawing the others: see probe.h.
    [[nodiscard]] Result<Explanation> probe(const DrawRequest& request, PixelPlace pixel,
                                            const DrawOptions& options = {});

    /// Finds the pixels of that picture that a texel contributes to: see contributions.h.
    [[nodiscard]] Result<Contributions>
    contributions(const DrawRequest& request, const TexelQuestion& question, const DrawOptions& options = {});

    /// Finds the levels that the pixels of that picture read: see level_map.h.
    [[nodiscard]] Result<LevelMap> levels(const DrawRequest& request, const LevelQuestion& question,
                                          const DrawOptions& options = {});

    /// Frees the memory that is cached for the next picture.
    void rest();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Draws one frame.
[[nodiscard]] Result<Frame> drawReference(const DrawRequest& request, const DrawOptions& options = {});

} // namespace texplorer::reference
