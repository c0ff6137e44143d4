#include "app/ui/services/lesson_work.h"

#include <gtest/gtest.h>

namespace texplorer::ui::lesson_work_test {
namespace {

lesson::LessonScene ofColor(glm::vec4 color) {
    lesson::LessonScene scene{defaultScene(), {}};
    scene.scene.view.background = color;
    return scene;
}

// Answers are identified by their place: one whose edits fail must not pass its place to the next.
TEST(LessonWork, KeepsThePlaceOfWhatHasNoPicture) {
    LessonWork work(When::AtOnce);
    work.pictures.ask({std::nullopt, ofColor({1, 0, 0, 1}), std::nullopt, ofColor({0, 1, 0, 1})});
    const auto pictures = work.pictures.take().value();
    ASSERT_TRUE(pictures);
    ASSERT_EQ(pictures->size(), 4U);
    EXPECT_FALSE((*pictures)[0]);
    EXPECT_FALSE((*pictures)[2]);
    ASSERT_TRUE((*pictures)[1] && (*pictures)[3]);
    const auto corner = [&](std::size_t i) { return (*pictures)[i]->at(0, 0); };
    EXPECT_EQ(corner(1)[0], std::byte{255});
    EXPECT_EQ(corner(3)[1], std::byte{255});
    EXPECT_FALSE(work.pictures.take()) << "once";
}

TEST(LessonWork, ForgetsAtRest) {
    LessonWork work(When::AtOnce);
    work.pictures.ask({ofColor({1, 0, 0, 1})});
    work.grades.ask({defaultScene(), defaultScene(), {}});
    work.rest();
    EXPECT_FALSE(work.pictures.take());
    EXPECT_FALSE(work.grades.take());
}

} // namespace
} // namespace texplorer::ui::lesson_work_test
