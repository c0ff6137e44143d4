#include "texplorer/sheet/axis_labels.h"

#include <gmock/gmock.h>

namespace texplorer::axis_labels_test {
namespace {

using sheet::AxisLabels;
using sheet::LabelKind;
using testing::ElementsAre;
using testing::Field;

std::vector<AxisLabels> labels(const std::vector<const char*>& axes, LabelKind kind) {
    std::vector<SweepAxis> parsed;
    for (const char* text : axes) {
        const Result<SweepAxis> axis = parseSweepAxis(defaultScene(), text);
        EXPECT_TRUE(axis) << text;
        parsed.push_back(axis.value_or(SweepAxis()));
    }
    return sheet::labelsOf(defaultScene(), parsed, kind);
}

TEST(AxisLabels, AreOpenGlsNamesOrThePanelsWords) {
    const char* axis = "textures[0].magFilter=*";
    const ParamRow& row = *paramAt(defaultScene(), "textures[0].magFilter")->row;
    EXPECT_THAT(labels({axis}, LabelKind::Names),
                ElementsAre(AxisLabels{std::string(row.label), {"GL_NEAREST", "GL_LINEAR"}}));
    EXPECT_THAT(labels({axis}, LabelKind::Words),
                ElementsAre(AxisLabels{std::string(row.label),
                                       {std::string(findRow(row.choices, "GL_NEAREST")->label),
                                        std::string(findRow(row.choices, "GL_LINEAR")->label)}}));
    EXPECT_NE(labels({axis}, LabelKind::Words), labels({axis}, LabelKind::Names));
}

TEST(AxisLabels, WordsHaveUnitsAndSayOnAndOff) {
    EXPECT_THAT(labels({"view.azimuth=0,22.5", "passes[0].lighting=*"}, LabelKind::Words),
                ElementsAre(Field(&AxisLabels::values, ElementsAre("0 deg", "22.5 deg")),
                            Field(&AxisLabels::values, ElementsAre("off", "on"))));
    EXPECT_THAT(labels({"view.azimuth=0,22.5", "passes[0].lighting=*"}, LabelKind::Names),
                ElementsAre(Field(&AxisLabels::values, ElementsAre("0", "22.5")),
                            Field(&AxisLabels::values, ElementsAre("false", "true"))));
}

TEST(AxisLabels, EqualTitlesSayTheirPaths) {
    const std::string label(paramAt(defaultScene(), "passes[0].units[0].enabled")->row->label);
    EXPECT_THAT(labels({"passes[0].units[0].enabled=*", "passes[0].units[1].enabled=*", "view.azimuth=1"},
                       LabelKind::Names),
                ElementsAre(Field(&AxisLabels::title, label + " (passes[0].units[0].enabled)"),
                            Field(&AxisLabels::title, label + " (passes[0].units[1].enabled)"),
                            Field(&AxisLabels::title,
                                  std::string(paramAt(defaultScene(), "view.azimuth")->row->label))));
}

} // namespace
} // namespace texplorer::axis_labels_test
