// The driver as an oracle: every format, type and alignment, uploaded and read back with glGetTexImage, is
// what core makes of the same bytes.

#include "tests/support/render_fixture.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/image/float_pixels.h"
#include "texplorer/upload/pixel_memory.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace texplorer::render::pixel_memory_test {
namespace {

using namespace test;

class PixelMemory : public RenderTest {
protected:
    static constexpr PixelExtent extent{5, 3, 1};

    /// What the driver keeps, in floats: GL_RGBA8 of colours or GL_RGBA32F_ARB, or a depth of 24 bits.
    std::vector<float> kept(const Bytes& memory, const UploadCall& call, bool asFloats = false) {
        const bool isDepth = call.layout.format == TransferFormat::DepthComponent;
        const TextureHandle texture = TextureHandle::create();
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glPixelStorei(GL_UNPACK_ALIGNMENT, call.unpacking.alignment);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, call.unpacking.rowLength);
        // Mesa 22.3 skips wrongly when it swaps or scales as well.
        const bool skips = !call.unpacking.swapBytes && call.scale == glm::vec4(1);
        glPixelStorei(GL_UNPACK_SKIP_ROWS, skips ? call.unpacking.skipRows : 0);
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, skips ? call.unpacking.skipPixels : 0);
        const bool swaps = call.unpacking.swapBytes && call.unpacking.rowLength == 0;
        // Mesa 22.3 ignores the row length when it swaps, and writes out of bounds.
        glPixelStorei(GL_UNPACK_SWAP_BYTES, swaps ? GL_TRUE : GL_FALSE);
        const Bytes given =
            call.unpacking.swapBytes && !swaps ? withSwappedBytes(memory, call.layout.type) : memory;
        constexpr std::array scales{GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
        constexpr std::array biases{GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
        for (int i = 0; i < 4; ++i) {
            glPixelTransferf(static_cast<GLenum>(scales.at(static_cast<std::size_t>(i))), call.scale[i]);
            glPixelTransferf(static_cast<GLenum>(biases.at(static_cast<std::size_t>(i))), call.bias[i]);
        }
        const GLint stored = isDepth ? GL_DEPTH_COMPONENT24 : asFloats ? GL_RGBA32F_ARB : GL_RGBA8;
        glTexImage2D(GL_TEXTURE_2D, 0, stored, extent.width, extent.height, 0,
                     static_cast<GLenum>(call.layout.format), static_cast<GLenum>(call.layout.type),
                     given.data() + (skips ? 0 : bytesOf(call, extent, 0, 0).first));
        for (int i = 0; i < 4; ++i) {
            glPixelTransferf(static_cast<GLenum>(scales.at(static_cast<std::size_t>(i))), 1);
            glPixelTransferf(static_cast<GLenum>(biases.at(static_cast<std::size_t>(i))), 0);
        }
        std::vector<float> values(15 * (isDepth ? 1 : 4));
        glGetTexImage(GL_TEXTURE_2D, 0, isDepth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, values.data());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return values;
    }

    static std::vector<float> computed(const Bytes& memory, const UploadCall& call, bool asFloats = false) {
        std::vector<float> values;
        const Image image = readPixels(memory, call, extent, asFloats);
        for (std::size_t i = 0; asFloats && i < image.pixels.size(); i += sizeof(FloatTexel)) {
            const FloatTexel texel = floatsAt(image.pixels.data() + i);
            values.insert(values.end(), texel.begin(), texel.end());
        }
        if (asFloats)
            return values;
        for (std::size_t i = 0; i < image.pixels.size(); i += image.format == PixelFormat::Depth32 ? 4 : 1)
            values.push_back(image.format == PixelFormat::Depth32
                                 ? static_cast<float>(depthAt(image.pixels.data() + i) / 4294967295.0)
                                 : static_cast<float>(std::to_integer<int>(image.pixels[i])) / 255);
        return values;
    }
};

Bytes randomBytes(std::uint64_t count, std::mt19937& random, bool areFloats) {
    Bytes bytes(static_cast<std::size_t>(count));
    for (std::byte& each : bytes)
        each = static_cast<std::byte>(random());
    for (std::size_t i = 0; areFloats && i + 4 <= bytes.size(); i += 4) {
        const float value = static_cast<float>(random() % 2001) / 1000 - 0.5F;
        std::memcpy(&bytes[i], &value, sizeof value);
    }
    return bytes;
}

/// Whether Mesa reads it as OpenGL 2.1 says: see boundOf.
bool isExact(const TransferTypeFacts& facts) {
    const bool isSigned = facts.type == TransferType::Byte || facts.type == TransferType::Short ||
                          facts.type == TransferType::Int;
    return !isSigned && !facts.isPacked();
}

/// In steps of 255. Mesa converts signed numbers as OpenGL 4.2 does, c / (2^(b - 1) - 1), extends 5 bits to 8
/// by repeating them, and computes with floats, not doubles.
double boundOf(const TransferTypeFacts& facts, bool scales) {
    const bool isSigned = facts.type == TransferType::Byte || facts.type == TransferType::Short ||
                          facts.type == TransferType::Int;
    const bool hasFiveBits = std::ranges::find(facts.bits, 5) != facts.bits.end();
    return isSigned && scales                                                       ? 2.01
           : isSigned || hasFiveBits || scales || facts.type == TransferType::Float ? 1.01
                                                                                    : 0.01;
}

TEST_F(PixelMemory, IsReadAsTheDriverReadsIt) {
    std::mt19937 random(1);
    int count = 0;
    for (const TransferFormatFacts& format : transferFormatFacts) {
        for (const TransferTypeFacts& type : transferTypeFacts) {
            if (!checkLayout({format.format, type.type}))
                continue;
            for (const int alignment : {1, 2, 4, 8}) {
                for (const bool swaps : {false, true}) {
                    UploadCall call{{format.format, type.type}};
                    call.unpacking = {alignment, random() % 2 != 0 ? 7 : 0, static_cast<int>(random() % 3),
                                      static_cast<int>(random() % 3),
                                      swaps && type.type != TransferType::Float};
                    const bool scales = alignment == 4 && format.format != TransferFormat::DepthComponent;
                    if (scales) {
                        call.scale = {2, 0.5F, 1, 1.5F};
                        call.bias = {-0.25F, 0.125F, 0, 0.5F};
                    }
                    const Bytes memory =
                        randomBytes(bytesRead(call, extent), random, type.type == TransferType::Float);
                    const double bound = boundOf(type, scales) / 255;
                    EXPECT_THAT(
                        computed(memory, call),
                        testing::Pointwise(testing::FloatNear(static_cast<float>(bound)), kept(memory, call)))
                        << rowOf(format.format).name << ' ' << rowOf(type.type).name << " aligned to "
                        << alignment << (swaps ? ", swapped" : "");
                    ++count;
                    if (format.format == TransferFormat::DepthComponent)
                        continue;
                    const float floatBound = isExact(type) ? 1e-6F : 4.01F / 255;
                    EXPECT_THAT(computed(memory, call, true),
                                testing::Pointwise(testing::FloatNear(floatBound), kept(memory, call, true)))
                        << rowOf(format.format).name << ' ' << rowOf(type.type).name << " as floats";
                }
            }
        }
    }
    EXPECT_EQ(count, 11 * 7 * 8 + 4 * 8 + 8 * 2 * 8);
}

} // namespace
} // namespace texplorer::render::pixel_memory_test
