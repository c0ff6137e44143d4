#pragma once

// What Texplorer is measured against, and the ratio to reach. Benchmarks are named as Google Benchmark prints
// them.

#include <array>
#include <vector>

namespace texplorer::bench {

enum class Goal {
    FasterBy,  ///< at least `target` times as fast as the peer
    CostsUpTo, ///< at most `target` times the peer's time
    TakesUpTo, ///< at most `target` seconds; there is no peer
};

struct Comparison {
    const char* name; ///< "BMP24 decode 4 MB"
    const char* ours;
    const char* peer;
    const char* peerName; ///< "stb_image"; of TakesUpTo, what the time is: "a frame at 60 Hz"
    Goal goal;
    double target;
};

inline constexpr std::array comparisons{
    Comparison{"BMP24 decode 1 MB", "bmpDecode/1", "bmpStb/1", "stb_image", Goal::FasterBy, 8},
    Comparison{"BMP24 decode 4 MB", "bmpDecode/4", "bmpStb/4", "stb_image", Goal::FasterBy, 8},
    Comparison{"BMP24 decode 16 MB", "bmpDecode/16", "bmpStb/16", "stb_image", Goal::FasterBy, 8},
    Comparison{"BMP24 decode 1 MB", "bmpDecode/1", "bmpMemcpy/1", "memcpy", Goal::CostsUpTo, 1.25},
    Comparison{"BMP24 decode 4 MB", "bmpDecode/4", "bmpMemcpy/4", "memcpy", Goal::CostsUpTo, 1.25},
    Comparison{"BMP24 decode 16 MB", "bmpDecode/16", "bmpMemcpy/16", "memcpy", Goal::CostsUpTo, 1.25},
    Comparison{"DDS DXT5 with mips 1 MB", "ddsDecode/dxt5/1", "ddsMemcpy/dxt5/1", "memcpy", Goal::CostsUpTo,
               1.25},
    Comparison{"DDS DXT5 with mips 16 MB", "ddsDecode/dxt5/16", "ddsMemcpy/dxt5/16", "memcpy",
               Goal::CostsUpTo, 1.25},
    Comparison{"DDS RGBA8 16 MB", "ddsDecode/rgba/16", "ddsMemcpy/rgba/16", "memcpy", Goal::CostsUpTo, 1.25},
    Comparison{"JPEG decode 1 MB", "jpegDecode/1", "jpegTurbo/1", "libjpeg-turbo in a bare call",
               Goal::CostsUpTo, 1.05},
    Comparison{"JPEG decode 16 MB", "jpegDecode/16", "jpegTurbo/16", "libjpeg-turbo in a bare call",
               Goal::CostsUpTo, 1.05},
    Comparison{"JPEG decode 16 MB", "jpegDecode/16", "jpegStb/16", "stb_image", Goal::FasterBy, 1},
    Comparison{"Mip chain 2048 × 2048", "mipChain", "mipChainDriver/process_time",
               "glGenerateMipmap on llvmpipe", Goal::FasterBy, 5},
    Comparison{"Mip chain 2048 × 2048", "mipChain", "mipChainGlu/process_time", "gluBuild2DMipmaps",
               Goal::FasterBy, 4},
    Comparison{"Mip chain 2048 × 2048", "mipChain", "mipChainStb", "stb_image_resize", Goal::FasterBy, 4},
    Comparison{"PNG write 1280 × 720", "pngWrite", "pngWriteLibpng", "libpng by default", Goal::FasterBy, 5},
    Comparison{"PNG read 1280 × 720", "pngRead", "pngReadLibpng", "libpng in a bare loop", Goal::CostsUpTo,
               1.05},
    Comparison{"Probe of a pixel, 640 × 480", "probePixel", nullptr, "a step of the mouse", Goal::TakesUpTo,
               0.001},
    Comparison{"DXT1 decode", "s3tcDecode/dxt1/1", "s3tcDecodeSquish/dxt1/1", "libsquish", Goal::FasterBy, 6},
    Comparison{"DXT3 decode", "s3tcDecode/dxt3/2", "s3tcDecodeSquish/dxt3/2", "libsquish", Goal::FasterBy, 6},
    Comparison{"DXT5 decode", "s3tcDecode/dxt5/2", "s3tcDecodeSquish/dxt5/2", "libsquish", Goal::FasterBy, 6},
    Comparison{"DXT1 flip 1 MB", "s3tcFlip/dxt1/1", "s3tcMemcpy/dxt1/1", "memcpy", Goal::FasterBy, 1},
    Comparison{"DXT1 flip 16 MB", "s3tcFlip/dxt1/16", "s3tcMemcpy/dxt1/16", "memcpy", Goal::FasterBy, 1},
    Comparison{"DXT3 flip 1 MB", "s3tcFlip/dxt3/1", "s3tcMemcpy/dxt3/1", "memcpy", Goal::FasterBy, 1},
    Comparison{"DXT3 flip 16 MB", "s3tcFlip/dxt3/16", "s3tcMemcpy/dxt3/16", "memcpy", Goal::FasterBy, 1},
    Comparison{"DXT5 flip 1 MB", "s3tcFlip/dxt5/1", "s3tcMemcpy/dxt5/1", "memcpy", Goal::FasterBy, 1},
    Comparison{"DXT5 flip 16 MB", "s3tcFlip/dxt5/16", "s3tcMemcpy/dxt5/16", "memcpy", Goal::FasterBy, 1},
    // The fast encoder is stb_dxt itself: this is what gathering the texels of a block may add.
    Comparison{"BC1 encode, fast", "bc1Encode/fast", "bc1EncodeStb", "stb_dxt", Goal::CostsUpTo, 1.03},
    Comparison{"frame 640 × 480", "frame/640/480/real_time", "frameBare/640/480/real_time", "a bare loop",
               Goal::CostsUpTo, 1.3},
    Comparison{"frame 1280 × 800", "frame/1280/800/real_time", "frameBare/1280/800/real_time", "a bare loop",
               Goal::CostsUpTo, 1.3},
    Comparison{"window 1280 × 800, a vertex of 8385 dragged", "windowDrag/real_time", nullptr,
               "a frame at 60 Hz", Goal::TakesUpTo, 1 / 60.0},
    Comparison{"window with the table of environments, moving", "figureFrame/environmentsMoving/real_time",
               nullptr, "a frame at 60 Hz", Goal::TakesUpTo, 1 / 60.0},
    Comparison{"window with the sheet, moving", "figureFrame/sheetMoving/real_time", nullptr,
               "a frame at 60 Hz", Goal::TakesUpTo, 1 / 60.0},
    Comparison{"GLSL frame 640 × 480", "frameShader/640/480/real_time", "frame/640/480/real_time",
               "fixed function", Goal::CostsUpTo, 1.2},
    Comparison{"GLSL frame 1280 × 800", "frameShader/1280/800/real_time", "frame/1280/800/real_time",
               "fixed function", Goal::CostsUpTo, 1.2},
    Comparison{"scene JSON read", "sceneParse", "sceneParseNlohmann", "nlohmann-json's own document",
               Goal::CostsUpTo, 1.5},
    Comparison{"scene JSON write", "sceneWrite", "sceneWriteNlohmann", "nlohmann-json's own document",
               Goal::CostsUpTo, 1.5},
    Comparison{"TGA raw 24 decode 1 MB", "tgaRaw24/1", "tgaRaw24Stb/1", "stb_image", Goal::FasterBy, 2.5},
    Comparison{"TGA raw 24 decode 4 MB", "tgaRaw24/4", "tgaRaw24Stb/4", "stb_image", Goal::FasterBy, 2.5},
    Comparison{"TGA raw 24 decode 16 MB", "tgaRaw24/16", "tgaRaw24Stb/16", "stb_image", Goal::FasterBy, 2.5},
    Comparison{"TGA raw 32 decode 4 MB", "tgaRaw32/4", "tgaRaw32Stb/4", "stb_image", Goal::FasterBy, 2.5},
    Comparison{"TGA RLE 24 decode 1 MB", "tgaRle24/1", "tgaRle24Stb/1", "stb_image", Goal::FasterBy, 8},
    Comparison{"TGA RLE 24 decode 4 MB", "tgaRle24/4", "tgaRle24Stb/4", "stb_image", Goal::FasterBy, 8},
    Comparison{"TGA RLE 24 decode 16 MB", "tgaRle24/16", "tgaRle24Stb/16", "stb_image", Goal::FasterBy, 8},
    Comparison{"TGA RLE 32 decode 4 MB", "tgaRle32/4", "tgaRle32Stb/4", "stb_image", Goal::FasterBy, 8},
    Comparison{"TGA RLE 24 photograph 4 MB", "tgaRlePhoto/4", "tgaRlePhotoStb/4", "stb_image", Goal::FasterBy,
               8},
    Comparison{"SSIM 1920 × 1080", "pictureSsim/real_time", "pictureSsimScikit/manual_time", "scikit-image",
               Goal::FasterBy, 4},
    Comparison{"FLIP 1920 × 1080", "pictureFlip/real_time", nullptr, "a second", Goal::TakesUpTo, 1},
    Comparison{"texshot shot", "processTexshotShot/real_time", "processMinimalOsmesa/real_time",
               "a minimal OSMesa program", Goal::CostsUpTo, 1.5},
    Comparison{"36 shots in one call, Mesa's cache cold", "shots/inOneCall/cold/iterations:1/manual_time",
               "shots/oneByOne/cold/iterations:1/manual_time", "one process per shot", Goal::FasterBy, 4},
    Comparison{"36 shots in one call, Mesa's cache warm", "shots/inOneCall/warm/iterations:1/manual_time",
               "shots/oneByOne/warm/iterations:1/manual_time", "one process per shot", Goal::FasterBy, 9},
    // With a warm cache, writing 36 PNG files is a third of the time, though it has threads of its own.
    Comparison{"36 shots in one call, Mesa's cache cold", "shots/inOneCall/cold/iterations:1/manual_time",
               "shots/bare/cold/iterations:1/manual_time", "a bare program without PNG", Goal::CostsUpTo,
               1.25},
    Comparison{"36 shots in one call, Mesa's cache warm", "shots/inOneCall/warm/iterations:1/manual_time",
               "shots/bare/warm/iterations:1/manual_time", "a bare program without PNG", Goal::CostsUpTo,
               1.6},
    Comparison{"a sheet of 64 pictures of 128 × 128, Mesa's cache cold",
               "sheet/inOneCall/cold/iterations:1/manual_time",
               "sheet/oneByOne/cold/iterations:1/manual_time", "one process per picture", Goal::FasterBy, 6},
    Comparison{"a sheet of 64 pictures of 128 × 128, Mesa's cache warm",
               "sheet/inOneCall/warm/iterations:1/manual_time",
               "sheet/oneByOne/warm/iterations:1/manual_time", "one process per picture", Goal::FasterBy, 6},
    Comparison{"60 pictures of 512 × 512 into a WebP", "animated/webp/iterations:1/manual_time",
               "animatedPeer/webp/iterations:1/manual_time", "drawing, then libwebp's own encoder",
               Goal::CostsUpTo, 1.5},
    Comparison{"60 pictures of 512 × 512 into a GIF", "animated/gif/iterations:1/manual_time",
               "animatedPeer/gif/iterations:1/manual_time", "drawing, then giflib's own colours",
               Goal::CostsUpTo, 1.5},
};

/// The rows of bench_reference.cpp: one for each scene and filter.
[[nodiscard]] std::vector<Comparison> frameComparisons();

} // namespace texplorer::bench
