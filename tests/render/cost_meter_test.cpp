// Every row can be measured, or says why not. What the times are is not tested.

#include "app/render/cost_meter.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

namespace texplorer::render::cost_meter_test {
namespace {

using namespace test;
using testing::Each;
using testing::Gt;
using testing::HasSubstr;
using testing::SizeIs;

constexpr std::size_t pairs = 2;

class CostMeterTest : public RenderTest {
protected:
    view::TextureCosts measure(const view::CostSubject& subject) {
        CostMeter meter(capabilities, subject, pairs);
        view::TextureCosts costs;
        while (meter.measure(costs, std::chrono::milliseconds(1000))) {
        }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return costs;
    }
    static view::CostSubject subject(Target target, int side = 32) {
        Image image = Image::uninitialised(PixelFormat::Rgba8, side, side);
        return {target, std::make_shared<const PreparedLevels>(
                            prepareLevels(Texture{}, textureOf(std::move(image), {}), target))};
    }
    static const view::CostTimes& named(const view::TextureCosts& costs, std::string_view name) {
        const auto found = std::ranges::find(view::costRows, name, &view::CostRow::name);
        return costs.at(static_cast<std::size_t>(found - view::costRows.begin()));
    }
};

TEST_F(CostMeterTest, MeasuresEveryRow) {
    const view::TextureCosts costs = measure(subject(Target::Texture2D));
    for (std::size_t i = 0; i < costs.size(); ++i) {
        SCOPED_TRACE(view::costRows.at(i).name);
        EXPECT_EQ(costs.at(i).lack.english(), "");
        EXPECT_THAT(costs.at(i).times.a, testing::AllOf(SizeIs(pairs), Each(Gt(0))));
        EXPECT_THAT(costs.at(i).times.b, testing::AllOf(SizeIs(pairs), Each(Gt(0))));
    }
    EXPECT_EQ(progressOf(costs, pairs), 1);
}

TEST_F(CostMeterTest, MeasuresTheTextureOfTheSceneWithOtherTargets) {
    for (const Target target : {Target::Texture1D, Target::CubeMap}) {
        const view::TextureCosts costs = measure(subject(target));
        EXPECT_EQ(costs.back().lack.english(), "");
        EXPECT_THAT(costs.back().times.b, SizeIs(pairs));
    }
}

TEST_F(CostMeterTest, SaysWhatTheDriverLacksAndMeasuresTheOtherRows) {
    capabilities.s3tc = false;
    capabilities.maxAnisotropy = 1;
    const view::TextureCosts costs = measure({Target::Texture2D, nullptr, "there is none"});
    EXPECT_THAT(named(costs, "upload-dxt1").lack.english(), HasSubstr("S3TC"));
    EXPECT_THAT(named(costs, "draw-dxt1").lack.english(), HasSubstr("S3TC"));
    EXPECT_THAT(named(costs, "anisotropy").lack.english(), HasSubstr("anisotrop"));
    EXPECT_EQ(named(costs, "scene").lack.english(), "there is none");
    EXPECT_TRUE(named(costs, "draw-dxt1").times.a.empty());
    for (const char* other : {"bind", "upload-size", "draw-size", "mipmaps", "linear"})
        EXPECT_THAT(named(costs, other).times.a, SizeIs(pairs)) << other;
}

TEST_F(CostMeterTest, ATextureTooLargeForAFrameIsNotMeasured) {
    EXPECT_THAT(measure(subject(Target::Texture2D, 2049)).back().lack.english(), HasSubstr("too large"));
}

TEST_F(CostMeterTest, ReturnsAfterTheGivenTimeAndGoesOn) {
    CostMeter meter(capabilities, {}, pairs);
    view::TextureCosts costs;
    EXPECT_TRUE(meter.measure(costs, std::chrono::milliseconds(0)));
    EXPECT_LT(progressOf(costs, pairs), 0.2) << "a step, however short the time is";
    while (meter.measure(costs, std::chrono::milliseconds(0))) {
    }
    EXPECT_EQ(progressOf(costs, pairs), 1);
}

} // namespace
} // namespace texplorer::render::cost_meter_test
