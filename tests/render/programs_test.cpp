// The documents' programs, as they are written there, against the scenes that say the same: glBegin and GLU
// on one side, assets/scenes on the other, pixel by pixel.

#include "app/render/render_target.h"
#include "tests/programs/programs.h"
#include "tests/support/render_fixture.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <system_error>

namespace texplorer::programs {

const Picture& pattern(std::string_view name) {
    static std::map<std::string, Picture, std::less<>> pictures;
    const auto known = pictures.find(name);
    if (known != pictures.end())
        return known->second;
    Picture& picture = pictures[std::string(name)];
    const EnumRow* row = findRow(patternRows, name);
    if (!row) {
        ADD_FAILURE() << "there is no pattern \"" << name << '"';
        return picture;
    }
    const Image image = drawPattern(static_cast<Pattern>(row->value));
    picture = {image.width, image.height, {}};
    std::ranges::transform(image.pixels, std::back_inserter(picture.texels),
                           [](std::byte each) { return std::to_integer<std::uint8_t>(each); });
    return picture;
}

} // namespace texplorer::programs

namespace texplorer::programs_test {
namespace {

using namespace test;

constexpr view::Size extent{320, 240};
constexpr int tolerance = 2; // 255ths

// Of 320 x 240 pixels, those in which the reference may differ from the programs, each for its reason.

/// OpenGL lets a driver approximate the level of detail (section 3.8.8): llvmpipe takes the differences
/// within blocks of two by two pixels, and mixes two levels by it.
constexpr int mipmapped = 280;
/// llvmpipe blends in the framebuffer's eight bits, as it may (section 4.1.8), and the last pass of an
/// embossed cube doubles what the passes before it have rounded. One step more than the tolerance.
constexpr int blendedTwice = 2;

struct Program {
    const char* name;
    void (*draw)(int width, int height);
    const char* scene;
    void (*adjust)(Scene& scene) = nullptr;
    int referenceMayDiffer = 0; ///< pixels
};

void setFilter(Scene& scene, MagFilter magFilter, MinFilter minFilter) {
    scene.textures.at(0).magFilter = magFilter;
    scene.textures.at(0).minFilter = minFilter;
}

const std::array allPrograms{
    Program{"Checker", programs::drawChecker, "checker"},
    Program{"Texbind", programs::drawTexbind, "texbind"},
    Program{"Line", programs::drawLine, "line"},
    Program{"Spiral", programs::drawSpiral, "spiral"},
    Program{"Quadrics", programs::drawQuadrics, "quadrics", nullptr, mipmapped},
    Program{"EarthNearest", programs::drawEarthNearest, "earth",
            [](Scene& scene) { setFilter(scene, MagFilter::Nearest, MinFilter::Nearest); }},
    Program{"EarthLinear", programs::drawEarthLinear, "earth",
            [](Scene& scene) { setFilter(scene, MagFilter::Linear, MinFilter::Linear); }},
    Program{"PackedPixels", programs::drawPackedPixels, "packed-pixels"},
    Program{"Texsub", programs::drawTexsub, "texsub"},
    Program{"NeheNoBumps", programs::drawNeheNoBumps, "nehe-no-bumps"},
    Program{"NeheBumpsOneUnit", programs::drawNeheBumpsOneUnit, "nehe-bumps-1-unit", nullptr, blendedTwice},
    Program{"NeheBumpsTwoUnits", programs::drawNeheBumpsTwoUnits, "nehe-bumps-2-units", nullptr,
            blendedTwice},
};

std::filesystem::path scenesFolder() {
    return TEXPLORER_SCENES;
}

Result<Scene> readScene(const std::string& name) {
    const Result<std::string> text = readText(scenesFolder() / (name + ".json"));
    return text ? parseScene(*text) : fail(text.error());
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    std::error_code unreadable; // no scenes, then: each is missed by name
    for (const auto& entry : std::filesystem::directory_iterator(scenesFolder(), unreadable))
        if (entry.path().extension() == ".json")
            names.push_back(entry.path().stem());
    std::ranges::sort(names);
    return names;
}

/// How many pixels differ by more than `allowed`, in any component but alpha, which no screen shows.
testing::AssertionResult areAlike(const Image& found, const Image& expected, int mayDiffer,
                                  int allowed = tolerance) {
    if (found.pixels.size() != expected.pixels.size())
        return testing::AssertionFailure() << "the pictures have different sizes";
    int others = 0;
    int worst = 0;
    std::string first;
    for (int y = 0; y < found.height; ++y) {
        for (int x = 0; x < found.width; ++x) {
            int difference = 0;
            for (std::size_t i = 0; i < 3; ++i)
                difference = std::max(difference, std::abs(std::to_integer<int>(found.at(x, y)[i]) -
                                                           std::to_integer<int>(expected.at(x, y)[i])));
            worst = std::max(worst, difference);
            if (difference <= allowed)
                continue;
            if (others++ == 0)
                first = std::to_string(x) + ", " + std::to_string(y);
        }
    }
    if (others <= mayDiffer)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << others << " pixels differ, by up to " << worst << "; the first is "
                                       << first << ", counted from the bottom left";
}

class Programs : public RenderTest {
protected:
    /// By OpenGL.
    Image drawn(const Scene& scene) {
        const Result<view::Frame> frame = renderer->draw(scene, images, 0, extent);
        EXPECT_TRUE(frame) << describe(frame.error());
        EXPECT_THAT(frame ? frame->problems : std::vector<Sentence>{}, testing::IsEmpty());
        const Result<Image> image = renderer->read();
        EXPECT_TRUE(image) << describe(image.error());
        return image.value_or(Image{});
    }

    Image reference(const Scene& scene) {
        const Result<Frame> frame =
            reference::drawReference({scene, images, 0, extent.width, extent.height, anisotropy()});
        EXPECT_TRUE(frame) << describe(frame.error());
        return frame ? frame->image : Image{};
    }

    static Image theirs(void (*draw)(int width, int height)) {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
        Image found = Image::uninitialised(PixelFormat::Rgba8, extent.width, extent.height);
        {
            render::RenderTarget target;
            EXPECT_TRUE(target.bind(extent));
            draw(extent.width, extent.height);
            glReadPixels(0, 0, extent.width, extent.height, GL_RGBA, GL_UNSIGNED_BYTE, found.pixels.data());
            EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        }
        glPopClientAttrib();
        glPopAttrib();
        return found;
    }
};

class DocumentPrograms : public Programs, public testing::WithParamInterface<Program> {};

TEST_P(DocumentPrograms, DrawTheirScenes) {
    const Program& program = GetParam();
    Result<Scene> scene = readScene(program.scene);
    ASSERT_TRUE(scene) << describe(scene.error());
    if (program.adjust)
        program.adjust(*scene);
    const Image expected = theirs(program.draw);
    EXPECT_TRUE(areAlike(drawn(*scene), expected, 0));
    EXPECT_TRUE(areAlike(reference(*scene), expected, program.referenceMayDiffer)) << "the reference";
}

INSTANTIATE_TEST_SUITE_P(All, DocumentPrograms, testing::ValuesIn(allPrograms),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(Programs, ComputeTheBoardThatIsOurPattern) {
    const programs::Picture& board = programs::pattern("checker");
    ASSERT_EQ(board.width, 64);
    ASSERT_EQ(board.height, 64);
    for (std::size_t i = 0; i < 64; ++i) {
        for (std::size_t j = 0; j < 64; ++j) {
            const std::uint8_t c = ((i & 8) == 0) != ((j & 8) == 0) ? 255 : 0; // as in checker.c
            const auto texel = std::span(board.texels).subspan(4 * (64 * i + j), 4);
            ASSERT_THAT(texel, testing::ElementsAre(c, c, c, 255)) << "row " << i << ", column " << j;
        }
    }
}

class DocumentScenes : public Programs, public testing::WithParamInterface<std::string> {};

/// Of the pixels of scenes with mipmaps, volumes and blending: see reference_test.cpp.
constexpr int scenesMayDiffer = extent.width * extent.height / 100;

TEST_P(DocumentScenes, AreTheSameInTheReference) {
    const Result<Scene> scene = readScene(GetParam());
    ASSERT_TRUE(scene) << describe(scene.error());
    // Levels that have nothing in common show how coarsely the driver computes the level of detail.
    const int allowed = scene->textures[0].mipmaps == MipPolicy::Given ? 16 : tolerance;
    EXPECT_TRUE(areAlike(drawn(*scene), reference(*scene), scenesMayDiffer, allowed));
}

INSTANTIATE_TEST_SUITE_P(All, DocumentScenes, testing::ValuesIn(sceneNames()), [](const auto& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

} // namespace
} // namespace texplorer::programs_test
