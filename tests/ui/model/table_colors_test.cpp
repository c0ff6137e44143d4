#include "app/ui/model/table_colors.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::table_colors_test {
namespace {

using namespace test;

class TableColors : public Workbench {
protected:
    /// A cube's pixel in the picture's left half, of a texture with colours.
    void probe() {
        texture().pattern = Pattern::UvTemplate;
        session->window.wantedTab = Tab::Figures;
        session->window.figure = Figure::Environments;
        session->look.explaining.pixel = {layout.picture.width / 4, layout.picture.height / 2};
        frames(2);
    }
};

TEST_F(TableColors, HaveTheWholeTexelWhateverTheTexturesFormatIs) {
    probe();
    const TableSubject whole = tableSubject(*session);
    ASSERT_TRUE(whole.probed);
    EXPECT_NE(whole.colors.texel.r, whole.colors.texel.b);
    EXPECT_EQ(whole.format, BaseFormat::Rgba);
    for (const InternalFormat format : {InternalFormat::Luminance, InternalFormat::Alpha}) {
        texture().internalFormat = format;
        frames(2);
        const TableSubject same = tableSubject(*session);
        EXPECT_EQ(same.colors.texel, whole.colors.texel);
        EXPECT_EQ(same.colors.fragment, whole.colors.fragment);
        EXPECT_EQ(same.format, baseFormat(format));
    }
}

TEST_F(TableColors, AreOfGlColorAndTheMeanWhereNoPixelIsProbed) {
    scene().material.color = {0.2F, 0.4F, 0.6F, 0.8F};
    unit().envColor = {0, 1, 0, 1};
    frames(2);
    const TableSubject subject = tableSubject(*session);
    EXPECT_FALSE(subject.probed);
    EXPECT_EQ(subject.colors.fragment, glm::vec4(0.2F, 0.4F, 0.6F, 0.8F));
    EXPECT_EQ(subject.colors.constant, glm::vec4(0, 1, 0, 1));
    ASSERT_TRUE(subject.texels);
    EXPECT_NEAR(subject.colors.texel.r, 0.5F, 0.01F); // half of a checkerboard's squares are white
}

} // namespace
} // namespace texplorer::ui::table_colors_test
