#pragma once

#include "core/base/result.h"
#include "core/reference/draw_request.h"
#include "core/scene/frame.h"
#include "core/texture/texture_levels.h"

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

/// How a frame is come by: it is the same whatever these are.
struct DrawOptions {
    unsigned threads = 0; ///< 0: as many as the processor has
    /// Draws every pixel by itself, with the functions that are written to be read (shade.h, sampler.h), many
    /// times as slowly. The same bytes: this is what proves it.
    bool literal = false;
    const Kernel* kernel = nullptr; ///< nullptr: the fastest that this processor has
    LevelWork levels{};             ///< for textures that are compressed at run time
    std::stop_token stop{};

    /// By either token.
    [[nodiscard]] bool isStopped() const { return stop.stop_requested() || levels.stop.stop_requested(); }
};

/// The largest picture, on each axis.
inline constexpr int maxPictureExtent = 16384;

/// Draws Scenes on the processor as the OpenGL 2.1 specification says, without OpenGL. Holds the textures of
/// the last scene, so that the next picture of it is ready sooner. An object serves one thread at a time, and
/// draws with several of its own; several objects, as the functions below, any number of threads at once:
/// scenes and images are only read.
class ReferenceRenderer {
public:
    ReferenceRenderer();
    ReferenceRenderer(ReferenceRenderer&&) noexcept;
    ReferenceRenderer& operator=(ReferenceRenderer&&) noexcept;
    ReferenceRenderer(const ReferenceRenderer&) = delete;
    ReferenceRenderer& operator=(const ReferenceRenderer&) = delete;
    ~ReferenceRenderer();

    /// An Rgba8 image of the request's size. Errors: OutOfRange for a size below 1 or above
    /// maxPictureExtent, TooLarge without memory, Cancelled after a stop request.
    [[nodiscard]] Result<Frame> draw(const DrawRequest& request, const DrawOptions& options = {});

    /// Why one pixel of that picture has its colour, without drawing the others: see probe.h.
    [[nodiscard]] Result<Explanation> probe(const DrawRequest& request, PixelPlace pixel,
                                            const DrawOptions& options = {});

    /// Which pixels of that picture a texel has a share in: see contributions.h.
    [[nodiscard]] Result<Contributions>
    contributions(const DrawRequest& request, const TexelQuestion& question, const DrawOptions& options = {});

    /// Which levels the pixels of that picture read: see level_map.h.
    [[nodiscard]] Result<LevelMap> levels(const DrawRequest& request, const LevelQuestion& question,
                                          const DrawOptions& options = {});

    /// Gives back the memory that it holds for the next picture.
    void rest();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// One frame.
[[nodiscard]] Result<Frame> drawReference(const DrawRequest& request, const DrawOptions& options = {});

} // namespace texplorer::reference
