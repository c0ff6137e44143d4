#include "app/ui/files/lessons.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/state/chosen_vertices.h"
#include "tests/ui/texture_space/plane_bench.h"

#include <glm/glm.hpp>

#include <limits>
#include <numeric>
#include <span>
#include <tuple>

namespace texplorer::ui::texture_space_panel_test {
namespace {

using namespace test;

class TextureSpace : public PlaneBench {};

TEST_F(TextureSpace, AVertexIsDraggedToOtherCoordinates) {
    session->look.selection.vertex = 2;
    ASSERT_EQ(coord(2), glm::vec4(1, 1, 0, 1));
    const float unitPixels = pixelsPerUnit();
    drag(place("coord:2"), {50, 20});
    EXPECT_NEAR(coord(2).x, 1 + 50 / unitPixels, 1e-4F);
    EXPECT_NEAR(coord(2).y, 1 - 20 / unitPixels, 1e-4F);
    EXPECT_EQ(coord(1), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(coord(6), glm::vec4(1, 1, 0, 1)) << "the other faces keep theirs";
    key('Z', {ctrl});
    EXPECT_EQ(coord(2), glm::vec4(1, 1, 0, 1));
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(TextureSpace, SmallPicturesLeaveTheChosenVertexInSight) {
    const auto covers = [this](const ImVec2& place) {
        return std::ranges::any_of(places.items, [place](const auto& item) {
            const WidgetPlaces::Item& box = item.second;
            return item.first.starts_with("patch-frame:") && box.left <= place.x && place.x <= box.right &&
                   box.top <= place.y && place.y <= box.bottom;
        });
    };
    session->look.explaining.pixel = {159, 165};
    frames(5);
    ASSERT_TRUE(std::ranges::any_of(places.items,
                                    [](const auto& item) { return item.first.starts_with("patch-frame:"); }));
    int covered = 0; // while none is selected
    for (const ImVec2& corner : {at(0, 0), at(1, 0), at(0, 1), at(1, 1)})
        covered += covers(corner);
    EXPECT_GT(covered, 0);
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
        session->look.selection.vertex = vertex;
        frames(3);
        const glm::vec4 place = coord(vertex);
        EXPECT_FALSE(covers(at(place.s, place.t))) << vertex;
    }
}

TEST_F(TextureSpace, OfVerticesAtOnePlaceTheChosenFacesIsTaken) {
    session->look.selection.vertex = 4; // of the back face
    clickAt(at(1, 1));
    ASSERT_TRUE(session->look.selection.vertex.has_value());
    const std::vector<std::uint32_t>& back = selectedMesh(*session).faces[1].vertices;
    EXPECT_NE(std::ranges::find(back, *session->look.selection.vertex), back.end());
}

TEST_F(TextureSpace, DraggingElsewhereMovesThePlaneNotTheScene) {
    const Scene before = scene();
    const Plane plane = session->look.plane;
    drag(at(0.5F, 0.5F), {30, 0});
    EXPECT_LT(session->look.plane.s, plane.s);
    drag(at(1, 1), {30, 0}, ImGuiMouseButton_Right); // a right drag never moves a vertex
    wheel(at(0.3F, 0.3F), 3);
    EXPECT_LT(session->look.plane.extent, plane.extent);
    EXPECT_EQ(scene(), before);
    click("fit plane");
    EXPECT_NEAR(session->look.plane.s, 0.5F, 1e-5F);
}

// Faces of a third of the picture's height, +x in the third column.
TEST_F(TextureSpace, ShowsTheFacesOfACubeMapSideBySide) {
    scene().textures[0].pattern = Pattern::CubeFaces;
    scene().passes[0].units[0].target = Target::CubeMap;
    frames(2);
    EXPECT_FALSE(has("coord:0")) << "a direction has no place here";
    const ImVec2 inPositiveX = at(0.69F, 0.4F);
    EXPECT_GT(shown(inPositiveX, 0), shown(inPositiveX, 1) + 80);
    const ImVec2 inPositiveY = at(0.44F, 0.66F);
    EXPECT_GT(shown(inPositiveY, 1), shown(inPositiveY, 0) + 60);
    const Scene before = scene();
    drag(at(0, 0), {30, 10});
    EXPECT_EQ(scene(), before);
}

struct Heavy {
    const char* name;
    Shape shape;
    int subdivision;
};

void PrintTo(const Heavy& heavy, std::ostream* out) {
    *out << heavy.name;
}

class HeavyMesh : public TextureSpace, public testing::WithParamInterface<Heavy> {
protected:
    HeavyMesh() {
        Scene heavy = defaultScene();
        heavy.models.resize(1);
        heavy.models[0].shape = GetParam().shape;
        heavy.models[0].slices = heavy.models[0].stacks = GetParam().subdivision;
        start(std::move(heavy), 2560, 1440);
    }
};

/// Dear ImGui aborts if a panel has more than 65535 vertices.
TEST_P(HeavyMesh, IsDrawnFromNearAndFarWithoutACrash) {
    for (const float extent : {0.02F, 1.6F, 20.0F, 112.0F, 200.0F}) {
        session->look.plane.extent = extent;
        session->look.selection.vertex = 5;
        (void)picture();
    }
    click("fit plane");
    (void)picture();
}

/// With two outlines, all vertices selected, and a board behind transparent parts.
TEST_P(HeavyMesh, IsDrawnTwiceWithEverythingChosenWithoutACrash) {
    texture().pattern = Pattern::Tree;
    unit().matrix = {{.op = MatrixOp::Scale, .amount = {0.5F, 0.5F, 1}}};
    std::vector<std::size_t> all(selectedMesh(*session).vertices.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    chooseVertices(session->look.selection, std::move(all));
    for (const float extent : {0.02F, 1.6F, 20.0F, 200.0F}) {
        session->look.plane.extent = extent;
        (void)picture();
    }
}

INSTANTIATE_TEST_SUITE_P(All, HeavyMesh,
                         testing::Values(Heavy{"Floor", Shape::Floor, 16}, Heavy{"Disk", Shape::Disk, 64},
                                         Heavy{"Teapot", Shape::Teapot, 16},
                                         Heavy{"Sphere32", Shape::Sphere, 32},
                                         Heavy{"Sphere64", Shape::Sphere, 64},
                                         Heavy{"Sphere256", Shape::Sphere, 256}),
                         [](const auto& test) { return test.param.name; });

/// A cube map has no vertices in this plane, whichever was selected before.
TEST_F(TextureSpace, OfACubeMapNoVertexIsUnderTheMouse) {
    unit().target = Target::CubeMap;
    session->look.selection.vertex = 3;
    const Scene before = scene();
    frames(2);
    drag(place("texture space"), {40, 0});
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(session->look.selection.vertex, 3U) << "and none is chosen or given up";
}

TEST_F(TextureSpace, TheLargestCoordinatesAreDrawnSomewhere) {
    constexpr float largest = std::numeric_limits<float>::max();
    scene().models[0].texCoords[0] = effectiveTexCoords(Model{}, selectedMesh(*session), 0);
    scene().models[0].texCoords[0].edit()[0] = {largest, -largest, 0, 1};
    session->look.selection.vertex = 0;
    frames(2);
    expectSoundFrame();
    session->look.plane.extent = 0.02F;
    frames(2);
    expectSoundFrame();
}

TEST_F(TextureSpace, ADragEndsSomewhere) {
    session->look.plane.extent = 200;
    for (int i = 0; i < 20; ++i) { // each by some 160 units, then the plane is brought back
        session->look.plane.s = 0.5F + static_cast<float>(i == 0 ? 0 : coord(2).x - 0.5F);
        session->look.selection.vertex = 2;
        frames(1);
        drag(place("coord:2"), {270, 0});
    }
    EXPECT_EQ(coord(2).x, 1000);
}

TEST_F(TextureSpace, ShowsTheImageItsWrappingAndItsBorder) {
    texture().wrapS = Wrap::ClampToBorder;
    texture().borderColor = {1, 0, 0, 1};
    states.textureSpace.legend = false; // it would cover the tested pixels
    frames(3);
    // checker.c: squares of 8 texels, the one at the lower left is black; t grows upwards.
    const float square = 1.0F / 8;
    EXPECT_EQ(shown(at(square / 2, 2.5F * square), 1), 0);
    EXPECT_EQ(shown(at(1.5F * square, 2.5F * square), 1), 255);
    const ImVec2 outside = at(-0.15F, 2.5F * square);
    EXPECT_GT(shown(outside, 0), 120);
    EXPECT_LT(shown(outside, 1), 40);
    const ImVec2 above =
        at(1.5F * square, 1 + 0.5F * square); // t still repeats, darker than the image itself
    EXPECT_GT(shown(above, 1), 120);
    EXPECT_LT(shown(above, 1), 200);
}

// Outside an opaque image, the border's alpha of 0 still shows the board.
TEST_F(TextureSpace, ABoardLiesBehindWhatIsTransparent) {
    states.textureSpace.legend = false;
    const auto isBoard = [this](ImVec2 place) {
        const auto at = [&](int c) { return shown(place, c); };
        for (const ImU32 tint : {ImU32(ui::color::board), ImU32(ui::color::boardLight)}) {
            if (ImGui::ColorConvertFloat4ToU32({static_cast<float>(at(0)) / 255,
                                                static_cast<float>(at(1)) / 255,
                                                static_cast<float>(at(2)) / 255, 1}) == tint)
                return true;
        }
        return false;
    };
    frames(3);
    EXPECT_FALSE(isBoard(at(0.3F, 0.9F))) << "the checkerboard is opaque";
    texture().wrapS = Wrap::ClampToBorder;
    texture().borderColor = {1, 0, 0, 0};
    frames(3);
    EXPECT_LT(shown(at(-0.15F, 0.4F), 0) - shown(at(-0.15F, 0.4F), 2), 20) << "not red";
    texture().pattern = Pattern::Tree;
    frames(3);
    EXPECT_TRUE(isBoard(at(0.05F, 0.9F))) << "the sky around the tree";
}

// Sides of neighbouring faces, and those of the quad, share lines and dots.
TEST_F(TextureSpace, WhatFacesShareIsDrawnOnce) {
    states.textureSpace.numbers = false;
    const auto vertices = [this](Shape shape) {
        scene().models[0].shape = shape;
        frames(3);
        for (const ImDrawList* list :
             std::span(&ImGui::GetDrawData()->CmdLists[0],
                       static_cast<std::size_t>(ImGui::GetDrawData()->CmdListsCount))) {
            if (std::string_view(list->_OwnerName) == "Texture space")
                return list->VtxBuffer.Size;
        }
        return 0;
    };
    const int quad = vertices(Shape::Quad);
    EXPECT_GT(quad, 0);
    EXPECT_EQ(vertices(Shape::Cube), quad);
}

// The middle of the plane is an edge of squares: a pixel centre on it would belong to both.
TEST_F(TextureSpace, TheSquaresHaveStraightEdges) {
    for (const auto& [width, height] : {std::pair{1280, 800}, {900, 600}, {1279, 799}, {1366, 768}}) {
        start(defaultScene(), width, height);
        const Image window = picture();
        const auto left = static_cast<int>(at(1.1F, 0).x); // beyond the image and its outlines
        const auto right = static_cast<int>(places.items.at("texture space").right) - 4;
        const auto top = static_cast<int>(at(0, 0.9F).y);
        const auto bottom = static_cast<int>(at(0, 0.1F).y);
        const auto isBright = [&](int x, int y) {
            return std::to_integer<int>(window.at(x, window.height - 1 - y)[0]) > 60;
        };
        int edges = 0;
        int whole = 0;
        for (int y = top; y < bottom; ++y) {
            int changed = 0;
            for (int x = left; x < right; ++x)
                changed += isBright(x, y) != isBright(x, y - 1) ? 1 : 0;
            edges += changed > 0 ? 1 : 0;
            whole += changed == right - left ? 1 : 0;
        }
        EXPECT_GE(edges, 5) << "of squares of an eighth";
        EXPECT_EQ(whole, edges) << "in a window of " << width << " x " << height;
    }
}

// OpenGL 2.1, table 3.19: a cube map is six images of one size.
TEST_F(TextureSpace, SaysTheSizeOfACubeMapsFaces) {
    EXPECT_TRUE(has("texture size:64 × 64"));
    scene().textures[0].pattern = Pattern::CubeFaces;
    frames(2);
    const ImageSource& images = session->document.images;
    const Surface& cross = images.find(texture())->surfaces.front();
    const std::string face = std::to_string(widthOf(cross) / 4);
    EXPECT_TRUE(
        has("texture size:" + std::to_string(widthOf(cross)) + " × " + std::to_string(heightOf(cross))));
    unit().target = Target::CubeMap;
    frames(2);
    EXPECT_TRUE(has("texture size:6 faces of " + face + " × " + face));
}

// OpenGL 2.1, 3.8.1: glTexImage1D has no height. gluBuild2DMipmaps makes 384 rows 512.
TEST_F(TextureSpace, SaysTheSizeThatWasUploaded) {
    unit().target = Target::Texture1D;
    frames(2);
    EXPECT_TRUE(has("texture size:64 × 1"));
    for (const auto& [lesson, step, size] :
         {std::tuple("lines", 0U, "64 × 1"), std::tuple("sizes", 1U, "512 × 512"),
          std::tuple("volumes", 0U, "32 × 32 × 32")}) {
        ASSERT_TRUE(openLessonNamed(*session, lesson, step));
        frames(3);
        EXPECT_TRUE(has(std::string("texture size:") + size)) << lesson;
    }
}

TEST_F(TextureSpace, ItsTitlesDontCoverEachOther) {
    for (const char* lesson : {"volumes", "dds", "lines", "wrap", "texgen", "sizes"}) {
        SCOPED_TRACE(lesson);
        ASSERT_TRUE(openLessonNamed(*session, lesson, 0));
        frames(4);
        std::vector<WidgetPlaces::Item> legend;
        for (const auto& [name, item] : places.items) {
            if (name.starts_with("legend:"))
                legend.push_back(item);
        }
        EXPECT_FALSE(legend.empty());
        for (const auto& [name, item] : places.items) {
            if (!name.starts_with("patch title:"))
                continue;
            for (const WidgetPlaces::Item& line : legend)
                EXPECT_FALSE(item.left < line.right && line.left < item.right && item.top < line.bottom &&
                             line.top < item.bottom)
                    << name;
        }
    }
}

TEST_F(TextureSpace, ShowsTheTexelsOfAVolumeBesideALongLegend) {
    ASSERT_TRUE(openLessonNamed(*session, "volumes", 0));
    frames(4);
    EXPECT_TRUE(has("legend:as looked up"));
    EXPECT_TRUE(has("patch title:level 0 · 32 × 32") || has("patch title:level 0"));
}

TEST_F(TextureSpace, TheListDragsSingleNumbers) {
    putListRight();
    drag(place("models[0].texCoords0[1][0]"), {40, 0});
    EXPECT_NEAR(coord(1).x, 1 + 40 * 0.005F, 0.006F);
    EXPECT_EQ(coord(1).y, 0);
    EXPECT_EQ(session->look.selection.vertex, std::optional<std::size_t>(1));
    key('Z', {ctrl});
    EXPECT_EQ(coord(1).x, 1);
}

TEST_F(TextureSpace, ButtonsEditEveryVertex) {
    putListRight();
    click("coords:× 2");
    EXPECT_EQ(coord(2), glm::vec4(2, 2, 0, 1));
    EXPECT_EQ(coord(22).x + coord(22).y, 2 * (effectiveTexCoords(Model{}, selectedMesh(*session), 0)[22].x +
                                              effectiveTexCoords(Model{}, selectedMesh(*session), 0)[22].y));
    click("coords:Flip s");
    EXPECT_EQ(coord(2), glm::vec4(-1, 2, 0, 1));
    click("coords:Reset");
    EXPECT_EQ(coord(2), glm::vec4(1, 1, 0, 1));
    EXPECT_TRUE(scene().models[0].texCoords[0].empty());
    key('Z', {ctrl});
    EXPECT_EQ(coord(2), glm::vec4(-1, 2, 0, 1));
}

TEST_F(TextureSpace, ThirdAndFourthCoordinatesCanBeShown) {
    putListRight();
    EXPECT_FALSE(has("models[0].texCoords0[0][3]"));
    click("show r, q");
    const auto width = [&](const char* number) {
        const WidgetPlaces::Item& item = places.items.at(number);
        return item.right - item.left;
    };
    EXPECT_NEAR(width("models[0].texCoords0[0][3]"), width("models[0].texCoords0[0][0]"), 2);
    drag(place("models[0].texCoords0[0][3]"), {40, 0});
    EXPECT_NEAR(coord(0).w, 1.2F, 0.006F);
}

TEST_F(TextureSpace, ListsTheVerticesOfTheChosenModel) {
    putListRight();
    click("model choice");
    click("model:1");
    EXPECT_EQ(session->look.selection.model, 1);
    const std::string face = selectedMesh(*session).faces.front().name;
    EXPECT_TRUE(has("face:" + face));
    click("face:" + face);
    EXPECT_TRUE(has("models[1].texCoords0[0][0]"));
}

} // namespace
} // namespace texplorer::ui::texture_space_panel_test
