#include "texplorer/scene/upload.h"

#include <gtest/gtest.h>

namespace texplorer::upload_test {
namespace {

constexpr auto byte = TransferType::UnsignedByte;

TEST(MemoryOfFiles, IsWhatTheirLoadersKeep) {
    const Upload upload;
    EXPECT_EQ(memoryOf(upload, PixelFormat::Rgb8, "BMP"), (MemoryLayout{{TransferFormat::Bgr, byte}, 4}));
    EXPECT_EQ(memoryOf(upload, PixelFormat::Rgba8, "TGA"), (MemoryLayout{{TransferFormat::Bgra, byte}, 1}));
    EXPECT_EQ(memoryOf(upload, PixelFormat::Rgb8, "PNG"), (MemoryLayout{{TransferFormat::Rgb, byte}, 1}));
    EXPECT_EQ(memoryOf(upload, PixelFormat::Luminance8, ""),
              (MemoryLayout{{TransferFormat::Luminance, byte}, 1}));
}

TEST(MemoryOfLayouts, IsTheUploadsOwn) {
    Upload upload{.custom = true, .memory = MemoryRows::Layout, .memoryFormat = TransferFormat::Rgb};
    upload.memoryType = TransferType::UnsignedShort565;
    upload.memoryAlignment = 8;
    EXPECT_EQ(memoryOf(upload, PixelFormat::Rgba8, "BMP"),
              (MemoryLayout{{TransferFormat::Rgb, TransferType::UnsignedShort565}, 8}));
    upload.memoryAlignment = 3; // not possible
    EXPECT_EQ(memoryOf(upload, PixelFormat::Rgba8, "BMP").alignment, 4);
    upload.custom = false;
    EXPECT_EQ(memoryOf(upload, PixelFormat::Rgb8, "BMP").pixels.format, TransferFormat::Bgr);
}

// The alignment of 4 that OpenGL begins with stays where it changes nothing.
TEST(FittingCalls, ReadTheMemoryAsItIs) {
    const MemoryLayout tight{{TransferFormat::Rgb, byte}, 1};
    EXPECT_EQ(fittingCall(tight, 16, false).unpacking.alignment, 4);
    EXPECT_EQ(fittingCall(tight, 15, false).unpacking.alignment, 1);
    EXPECT_EQ(fittingCall({{TransferFormat::Bgr, byte}, 4}, 15, false),
              (UploadCall{{TransferFormat::Bgr, byte}}));
    EXPECT_EQ(fittingCall({{TransferFormat::Rgb, byte}, 8}, 15, false).unpacking.alignment, 4)
        << "48 bytes either way";
    EXPECT_EQ(fittingCall({{TransferFormat::Luminance, byte}, 1}, 4, true).layout.format,
              TransferFormat::DepthComponent);
}

TEST(FittingUploads, KeepTheMemory) {
    Upload upload{.memory = MemoryRows::Layout, .memoryFormat = TransferFormat::Bgr};
    upload.skipRows = 3;
    const Upload fitting = fittingUpload(upload, {{TransferFormat::Bgr, byte}, 1}, 15, false);
    EXPECT_TRUE(fitting.custom);
    EXPECT_EQ(fitting.memory, MemoryRows::Layout);
    EXPECT_EQ(fitting.memoryFormat, TransferFormat::Bgr);
    EXPECT_EQ(callOf(fitting), (UploadCall{{TransferFormat::Bgr, byte}, {.alignment = 1}}));
}

} // namespace
} // namespace texplorer::upload_test
