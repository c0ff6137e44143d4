#include "texplorer/reference/contributions.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/probe.h"
#include "texplorer/reference/sampling/texture_store.h"

#include <gmock/gmock.h>

#include <functional>

namespace texplorer::reference::texture_store_test {
namespace {

/// A compressed picture that two units sample.
Scene sceneWithTwoUnits() {
    Scene scene = defaultScene();
    scene.textures[0].compression = Compression::Cached;
    scene.textures[0].compressionQuality = EncodeQuality::Fast;
    scene.passes[0].units[1] = scene.passes[0].units[0];
    return scene;
}

/// Requests a stop right after the levels were made: too late for them.
struct LateStop {
    std::stop_source source;
    LevelWork work{{},
                   [this](float done) {
                       if (done >= 1)
                           source.request_stop();
                   },
                   source.get_token()};
};

class Store : public testing::Test {
protected:
    const StoredTexture* prepare(Target target = Target::Texture2D, const LevelWork& work = {}) {
        return store.prepare(scene, 0, target, images, work, problems);
    }

    Scene scene = sceneWithTwoUnits();
    ImageSource images;
    std::vector<Sentence> problems;
    TextureStore store;
};

TEST_F(Store, KeepsLevelsThatWereMadeBeforeTheStop) {
    LateStop late;
    const StoredTexture* stored = prepare(Target::Texture2D, late.work);
    ASSERT_TRUE(late.source.stop_requested());
    ASSERT_NE(stored, nullptr);
    const glm::vec4* texels = stored->sampled.level(0)->texels.data();
    const StoredTexture* again = prepare(Target::Texture2D, late.work);
    ASSERT_EQ(again, stored);
    EXPECT_EQ(again->sampled.level(0)->texels.data(), texels) << "another thread may be reading these";
}

TEST_F(Store, BeginsAgainAfterAStop) {
    for (const Compression compression : {Compression::Cached, Compression::Driver}) {
        scene.textures[0].compression = compression;
        std::stop_source stopped;
        stopped.request_stop();
        EXPECT_EQ(prepare(Target::Texture2D, {{}, {}, stopped.get_token()}), nullptr);
        EXPECT_THAT(problems, testing::IsEmpty()) << "the stop is no fault of the texture";
        const StoredTexture* stored = prepare();
        ASSERT_NE(stored, nullptr);
        EXPECT_EQ(stored->sampled.format, BaseFormat::Rgb);
        problems.clear();
    }
}

TEST_F(Store, HoldsWhatTheSceneSamplesAlone) {
    scene.textures[0].compression = Compression::None;
    scene.textures[0].source = SourceKind::File;
    scene.textures[0].file = "grey";
    images.put("grey", Image{PixelFormat::Luminance8, 1, 1, 1, {std::byte{128}}});
    scene.textures.push_back(scene.textures[0]);
    const std::shared_ptr<const TextureImage> image = images.find(scene.textures[0]);
    const long unused = image.use_count();
    for (const Target target : {Target::Texture2D, Target::Texture3D, Target::CubeMap, Target::Texture2D}) {
        for (Unit& unit : scene.passes[0].units)
            unit.target = target;
        store.keepOnly(scene);
        ASSERT_NE(prepare(target), nullptr);
        EXPECT_EQ(image.use_count(), unused + 1);
    }
    scene.passes[0].units[0].texture = 1;
    store.keepOnly(scene);
    EXPECT_EQ(image.use_count(), unused + 1) << "the second unit is on and samples it";
    scene.passes[0].units[1].enabled = false;
    store.keepOnly(scene);
    EXPECT_EQ(image.use_count(), unused);
}

// A stop for the levels alone works too; the first unit's texels stay valid.
struct Question {
    const char* name;
    std::function<ErrorCode(ReferenceRenderer&, const Scene&, const DrawOptions&)> ask;
};
template<class T>
ErrorCode codeOf(const Result<T>& result) {
    return result ? ErrorCode::NotFound : result.error().code;
}
class LateStopped : public testing::TestWithParam<Question> {};
TEST_P(LateStopped, IsCancelled) {
    LateStop late;
    ReferenceRenderer renderer;
    DrawOptions options;
    options.levels = late.work;
    EXPECT_EQ(GetParam().ask(renderer, sceneWithTwoUnits(), options), ErrorCode::Cancelled);
    EXPECT_TRUE(late.source.stop_requested());
}
INSTANTIATE_TEST_SUITE_P(
    All, LateStopped,
    testing::Values(Question{"Picture",
                             [](ReferenceRenderer& renderer, const Scene& scene, const DrawOptions& options) {
                                 return codeOf(renderer.draw({scene, {}, 0, 64, 48}, options));
                             }},
                    Question{"Probe",
                             [](ReferenceRenderer& renderer, const Scene& scene, const DrawOptions& options) {
                                 return codeOf(renderer.probe({scene, {}, 0, 64, 48}, {20, 24}, options));
                             }},
                    Question{"Contributions",
                             [](ReferenceRenderer& renderer, const Scene& scene, const DrawOptions& options) {
                                 return codeOf(renderer.contributions({scene, {}, 0, 64, 48}, {}, options));
                             }}),
    [](const auto& test) { return std::string(test.param.name); });

// Unlike a unit without a texture, which is Unsupported.
TEST(StoppedContributions, AreCancelled) {
    std::stop_source stopped;
    stopped.request_stop();
    DrawOptions options;
    options.stop = options.levels.stop = stopped.get_token();
    EXPECT_EQ(codeOf(contributions({sceneWithTwoUnits(), {}, 0, 64, 48}, {}, options)), ErrorCode::Cancelled);
}

} // namespace
} // namespace texplorer::reference::texture_store_test
