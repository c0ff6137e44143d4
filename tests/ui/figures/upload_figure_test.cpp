#include "tests/ui/figures/figure_bench.h"

namespace texplorer::ui::upload_figure_test {
namespace {

using namespace test;

class UploadFigure : public FigureBench {
protected:
    UploadFigure() {
        start(defaultScene(), 1280, 1000);
        // The checkerboard of 64 texels in 192 bytes a row.
        texture().upload = {.custom = true,
                            .memory = MemoryRows::Layout,
                            .memoryFormat = TransferFormat::Bgr,
                            .format = TransferFormat::Rgb,
                            .alignment = 1,
                            .rowLength = 63};
        show(Figure::Upload);
    }
    [[nodiscard]] UploadFigureState& state() { return figures().upload; }
};

TEST_F(UploadFigure, ATexelUnderThePointerMarksItsBytes) {
    moveTo(place("upload:texel 2 1"));
    frames(2);
    EXPECT_EQ(state().hovered.texel, (TexelPlace{2, 1}));
    moveTo(place("upload:byte 0"));
    frames(2);
    EXPECT_EQ(state().hovered.byte, std::size_t{0});
    EXPECT_FALSE(state().hovered.texel);
}

TEST_F(UploadFigure, AClickOnATexelBringsItsBytesIntoView) {
    constexpr const char* byte = "upload:byte 5934"; // 31 rows of 189 bytes, and 25 pixels of 3
    EXPECT_FALSE(has(byte));
    clickAt(place("upload:texel 25 31"));
    frames(2);
    EXPECT_TRUE(has(byte));
}

TEST_F(UploadFigure, WithoutACustomUploadOffersOneThatFits) {
    EXPECT_FALSE(has("upload:custom"));
    texture().upload = {};
    frames(4);
    expectAll({"upload:verdict", "upload:texels"});
    click("upload:custom");
    frames(3);
    EXPECT_EQ(texture().upload, (Upload{.custom = true})) << "RGBA, as the pattern is";
    EXPECT_FALSE(has("upload:custom"));
    EXPECT_EQ(steps(), 1U);
}

TEST_F(UploadFigure, SaysWhyThereIsNothingToRead) {
    texture().upload.type = TransferType::UnsignedShort4444; // with GL_RGB
    frames(4);
    EXPECT_TRUE(has("upload:problem"));
    EXPECT_FALSE(has("upload:texels"));
    scene().textures.clear();
    frames(3);
    EXPECT_FALSE(has("upload:verdict"));
}

} // namespace
} // namespace texplorer::ui::upload_figure_test
