// The peers of the mip chain that need OpenGL: the driver's own (llvmpipe) and GLU's. The driver works on
// many threads and we on one: what counts is the time of all of them together.

#include "app/offscreen/context.h"
#include "app/render/capabilities.h"
#include "texplorer/image/image.h"

#include <GL/glew.h>
#include <GL/glu.h>
#include <benchmark/benchmark.h>

#include <cstdlib>

namespace texplorer::bench {
namespace {

constexpr int extent = 2048;

/// A context, a texture in it and the picture to put there.
class MipTexture {
public:
    MipTexture()
        : context_(offscreen::Context::create({16, 16})) {
        if (!context_ || !render::loadCapabilities())
            std::abort();
        for (std::size_t i = 0; i < base_.pixels.size(); ++i)
            base_.pixels[i] = static_cast<std::byte>(i * 7 + i / 4099);
        GLuint name = 0; // goes with the context
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D, name);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, extent, extent, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels());
    }

    [[nodiscard]] const void* pixels() const { return base_.pixels.data(); }

private:
    Image base_ = Image::uninitialised(PixelFormat::Rgba8, extent, extent);
    Result<offscreen::Context> context_;
};

void mipChainDriver(benchmark::State& state) {
    const MipTexture texture;
    for (auto _ : state) {
        glGenerateMipmap(GL_TEXTURE_2D);
        glFinish();
    }
    if (glGetError() != GL_NO_ERROR)
        state.SkipWithError("glGenerateMipmap failed");
}

/// It uploads the levels, too.
void mipChainGlu(benchmark::State& state) {
    const MipTexture texture;
    for (auto _ : state) {
        if (gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGBA8, extent, extent, GL_RGBA, GL_UNSIGNED_BYTE,
                              texture.pixels()) != 0)
            state.SkipWithError("gluBuild2DMipmaps failed");
        glFinish();
    }
}

BENCHMARK(mipChainDriver)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(mipChainGlu)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

} // namespace
} // namespace texplorer::bench
