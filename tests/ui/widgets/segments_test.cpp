#include "app/ui/widgets/segments.h"
#include "tests/ui/workbench.h"

#include <numeric>

namespace texplorer::ui::segments_test {
namespace {

using namespace test;

class Segments : public Workbench {
protected:
    static std::vector<Segment> named(std::initializer_list<const char*> names) {
        std::vector<Segment> all;
        for (const char* name : names)
            all.push_back({name});
        return all;
    }
    /// Whether each text has its room.
    static void expectUncut(const std::vector<Segment>& segments, const SegmentPlan& plan, float width) {
        std::size_t i = 0;
        for (const SegmentPlan::Line& line : plan.lines) {
            EXPECT_LE(std::accumulate(line.widths.begin(), line.widths.end(), plan.names), width + 0.01F);
            for (const float each : line.widths)
                EXPECT_GE(each, ImGui::CalcTextSize(segments.at(i++).text.english().c_str()).x);
        }
        EXPECT_EQ(i, segments.size());
    }
};

TEST_F(Segments, TakeAsFewLinesAsHaveRoom) {
    const std::vector<Segment> wraps = named({"Repeat", "Mirror", "Edge", "Border", "Clamp"});
    std::size_t lines = 1;
    for (const float width : {600.0F, 300.0F, 200.0F, 120.0F}) {
        const std::optional<SegmentPlan> plan = planSegments(wraps, width, 5);
        ASSERT_TRUE(plan) << width;
        expectUncut(wraps, *plan, width);
        EXPECT_GE(plan->lines.size(), lines);
        lines = plan->lines.size();
    }
    EXPECT_GT(lines, 1U);
    EXPECT_EQ(planSegments(wraps, 600, 5)->lines.size(), 1U);
}

TEST_F(Segments, AreNoneWhereATextWouldBeCut) {
    EXPECT_FALSE(planSegments(named({"GL_NEAREST_MIPMAP_NEAREST", "GL_LINEAR"}), 100, 3));
    EXPECT_FALSE(planSegments(named({"Repeat", "Mirror", "Edge"}), 60, 2)) << "they would take three lines";
    EXPECT_FALSE(planSegments({}, 100, 3));
    EXPECT_FALSE(planSegments(named({"a"}), 0, 3));
}

TEST_F(Segments, HaveRoomForTheirTextsInTheWindowsLanguage) {
    const std::vector<CatalogueFile> files{
        {"ru/test.po", "msgid \"\"\nmsgstr \"\"\n\nmsgid \"Edge\"\nmsgstr \"Краевые тексели\"\n"}};
    const Result<Catalogue> catalogue = Catalogue::parse(Language::Russian, files);
    ASSERT_TRUE(catalogue);
    const std::vector<Segment> wraps = named({"Edge", "Clamp"});
    EXPECT_TRUE(planSegments(wraps, 120, 1));
    useCatalogue(&*catalogue);
    EXPECT_FALSE(planSegments(wraps, 120, 1)) << "the translation is longer";
    const std::optional<SegmentPlan> plan = planSegments(wraps, 240, 1);
    ASSERT_TRUE(plan);
    EXPECT_GE(plan->lines[0].widths[0], ImGui::CalcTextSize("Краевые тексели").x);
    useCatalogue(nullptr);
}

TEST_F(Segments, OfAGroupHaveALineEach) {
    std::vector<Segment> filters = named({"Nearest", "Linear", "Nearest", "Trilinear"});
    filters[0].group = filters[1].group = "No mipmaps";
    filters[2].group = filters[3].group = "Blended mips";
    const std::optional<SegmentPlan> plan = planSegments(filters, 300, 3);
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->lines.size(), 2U);
    EXPECT_EQ(plan->lines[1].group, "Blended mips");
    EXPECT_EQ(plan->lines[0].widths, plan->lines[1].widths) << "in columns";
    expectUncut(filters, *plan, 300);
    EXPECT_FALSE(planSegments(filters, 300, 1));
    EXPECT_FALSE(planSegments(filters, 150, 3)) << "the names need their room, too";
}

} // namespace
} // namespace texplorer::ui::segments_test
