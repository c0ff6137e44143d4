#include "app/ui/model/tex_coord_edits.h"

#include <gtest/gtest.h>

namespace texplorer::ui::tex_coord_edits_test {
namespace {

struct Case {
    const char* name;
    void (*edit)(TexCoords& coords);
    TexCoords expected; // of (0, 0), (1, 0), (1, 1), (0.25, 0.75) with r = 3, q = 2
};

TEST(TexCoordEdits, GiveTheNumbersWorkedOutByHand) {
    for (const Case& row :
         {Case{"Double",
               [](TexCoords& c) { scaleCoords(c, 2); },
               {{0, 0, 3, 2}, {2, 0, 3, 2}, {2, 2, 3, 2}, {0.5F, 1.5F, 3, 2}}},
          Case{"FlipS", flipS, {{1, 0, 3, 2}, {0, 0, 3, 2}, {0, 1, 3, 2}, {0.75F, 0.75F, 3, 2}}},
          Case{"FlipT", flipT, {{0, 1, 3, 2}, {1, 1, 3, 2}, {1, 0, 3, 2}, {0.25F, 0.25F, 3, 2}}},
          // Counter-clockwise about (0.5, 0.5): the lower left corner goes to the lower right one.
          Case{"Rotate", rotateQuarter, {{1, 0, 3, 2}, {1, 1, 3, 2}, {0, 1, 3, 2}, {0.25F, 0.25F, 3, 2}}}}) {
        TexCoords coords{{0, 0, 3, 2}, {1, 0, 3, 2}, {1, 1, 3, 2}, {0.25F, 0.75F, 3, 2}};
        row.edit(coords);
        EXPECT_EQ(coords, row.expected) << row.name;
    }
}

} // namespace
} // namespace texplorer::ui::tex_coord_edits_test
