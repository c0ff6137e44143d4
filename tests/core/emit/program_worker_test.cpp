#include "tests/support/no_threads.h"
#include "tests/support/paused_encoding.h"
#include "texplorer/emit/program_worker.h"

#include <gmock/gmock.h>

namespace texplorer::emit::program_worker_test {
namespace {

using test::PausedEncoding;

/// A scene whose texels take long to make.
Scene compressed(Pattern pattern = Pattern::Brick) {
    Scene scene = defaultScene();
    scene.textures[0].pattern = pattern;
    scene.textures[0].compression = Compression::Cached;
    return scene;
}

std::vector<Line> expected(const Scene& scene) {
    TextureCodes codes;
    return program(Flavour::Fixed, scene, {}, {}, codes).value();
}

std::optional<ProgramWorker::Program> ask(ProgramWorker& worker, const Scene& scene) {
    return worker.program(Flavour::Fixed, scene, {}, {});
}

/// Makes its texels, which are then kept.
void makeOnce(ProgramWorker& worker) {
    EXPECT_FALSE(ask(worker, compressed()));
    worker.wait();
    EXPECT_TRUE(ask(worker, compressed()));
}

/// Compares the numbers of arrays by value, not by their maker.
void expectProgram(const std::optional<ProgramWorker::Program>& made, const Scene& scene) {
    ASSERT_TRUE(made);
    ASSERT_TRUE(*made) << describe(made->error());
    EXPECT_EQ(textOf(made->value(), true), textOf(expected(scene), true));
}

TEST(ProgramWorker, WhatIsQuickIsThereAtOnce) {
    bool woken = false;
    ProgramWorker worker(When::WhenReady, [&] { woken = true; });
    expectProgram(ask(worker, defaultScene()), defaultScene());
    EXPECT_FALSE(worker.isMaking());
    worker.wait();
    EXPECT_FALSE(woken);
}

TEST(ProgramWorker, WhatTakesLongIsMadeByAThread) {
    PausedEncoding paused;
    ProgramWorker worker(When::WhenReady, {}, paused.work());
    EXPECT_FALSE(ask(worker, compressed()));
    paused.waitUntilBegun();
    EXPECT_TRUE(worker.isMaking());
    EXPECT_FALSE(ask(worker, compressed())) << "still";
    paused.goOn();
    worker.wait();
    expectProgram(ask(worker, compressed()), compressed());
    EXPECT_FALSE(worker.isMaking());
    EXPECT_EQ(paused.shares.size(), 1U) << "made once";
}

// If the texels exist, a dragged number needs no thread.
TEST(ProgramWorker, ANumberIsChangedAtOnce) {
    PausedEncoding paused;
    paused.goOn();
    ProgramWorker worker(When::WhenReady, {}, paused.work());
    makeOnce(worker);
    Scene turned = compressed();
    turned.view.azimuth += 5;
    turned.textures[0].wrapS = Wrap::ClampToEdge;
    expectProgram(ask(worker, turned), turned);
    EXPECT_EQ(paused.shares.size(), 1U);
}

TEST(ProgramWorker, ANumberThatChangesMeanwhileBeginsNothingAnew) {
    PausedEncoding paused;
    ProgramWorker worker(When::WhenReady, {}, paused.work());
    EXPECT_FALSE(ask(worker, compressed()));
    paused.waitUntilBegun();
    Scene turned = compressed();
    turned.view.azimuth += 5;
    EXPECT_FALSE(ask(worker, turned));
    paused.goOn();
    worker.wait();
    expectProgram(ask(worker, turned), turned);
    EXPECT_EQ(paused.shares.size(), 1U);
}

TEST(ProgramWorker, TheNewestSceneGivesUpWhatTheOneBeforeNeeded) {
    PausedEncoding paused(0.01F);
    LevelWork work = paused.work();
    int ended = 0; // of the thread that works, until it is waited for
    work.progress = [&, progress = work.progress](float share) {
        ended += share == 1 ? 1 : 0;
        progress(share);
    };
    ProgramWorker worker(When::WhenReady, {}, work);
    EXPECT_FALSE(ask(worker, compressed(Pattern::Planet)));
    paused.waitUntilBegun();
    EXPECT_FALSE(ask(worker, compressed()));
    paused.goOn();
    worker.wait();
    EXPECT_EQ(ended, 1);
    expectProgram(ask(worker, compressed()), compressed());
}

TEST(ProgramWorker, AQuickSceneNeedsNotWaitForAnother) {
    PausedEncoding paused(0.5F);
    ProgramWorker worker(When::WhenReady, {}, paused.work());
    EXPECT_FALSE(ask(worker, compressed()));
    paused.waitUntilBegun();
    expectProgram(ask(worker, defaultScene()), defaultScene());
    EXPECT_FALSE(worker.isMaking());
    paused.goOn();
}

TEST(ProgramWorker, TwoTexturesThatAreAlikeAreMadeOnce) {
    PausedEncoding paused;
    paused.goOn();
    ProgramWorker worker(When::WhenReady, {}, paused.work());
    Scene scene = compressed();
    scene.textures.push_back(scene.textures[0]);
    EXPECT_FALSE(ask(worker, scene));
    worker.wait();
    expectProgram(ask(worker, scene), scene);
    EXPECT_EQ(paused.shares.size(), 1U);
}

// The unit is drawn at the times when key frames enable it.
TEST(ProgramWorker, MakesWhatAUnitShowsThatKeyFramesSwitchOn) {
    PausedEncoding paused;
    paused.goOn();
    ProgramWorker worker(When::WhenReady, {}, paused.work());
    Scene scene = compressed();
    scene.passes[0].units[0].enabled = false;
    scene.passes[0].units[0].target = Target::CubeMap;
    scene.timeline.keys = {{0, "passes[0].units[0].enabled", "false"},
                           {1, "passes[0].units[0].enabled", "true"}};
    EXPECT_FALSE(ask(worker, scene));
    worker.wait();
    const std::size_t faces = paused.shares.size();
    expectProgram(ask(worker, scene), scene);
    EXPECT_EQ(paused.shares.size(), faces) << "none on the thread that asks";
}

TEST(ProgramWorker, ForgetsWhatNobodyLooksAt) {
    PausedEncoding paused;
    paused.goOn();
    ProgramWorker worker(When::WhenReady, {}, paused.work());
    makeOnce(worker);
    worker.rest();
    EXPECT_FALSE(worker.isMaking());
    makeOnce(worker);
    EXPECT_EQ(paused.shares.size(), 2U);
}

TEST(ProgramWorker, IsThereAtOnceForAProgramWithoutAUser) {
    ProgramWorker worker(When::AtOnce);
    expectProgram(ask(worker, compressed()), compressed());
    EXPECT_FALSE(worker.isMaking());
}

TEST(ProgramWorker, WorksWithoutAThread) {
    const test::NoThreads none;
    ProgramWorker worker(When::WhenReady);
    expectProgram(ask(worker, compressed()), compressed());
}

Scene large(float fieldOfView) {
    Scene scene = defaultScene();
    scene.view.fieldOfView = fieldOfView;
    scene.models[0].shape = Shape::Mesh;
    scene.models[0].mesh.positions.resize(6000);
    return scene;
}

TEST(ProgramWorker, WritesLargeMeshesBeside) {
    ProgramWorker worker(When::WhenReady);
    const bool isWritten = ask(worker, large(40)).has_value(); // the thread may be faster
    EXPECT_EQ(worker.isMaking(), !isWritten);
    worker.wait();
    expectProgram(ask(worker, large(40)), large(40));
    EXPECT_FALSE(worker.isMaking());
}

TEST(ProgramWorker, WritesTheNewestProgram) {
    ProgramWorker worker(When::WhenReady);
    for (int i = 0; i < 20; ++i)
        static_cast<void>(ask(worker, large(static_cast<float>(70 + i))));
    worker.wait();
    expectProgram(ask(worker, large(89)), large(89));
    worker.rest();
    EXPECT_FALSE(worker.isMaking());
    expectProgram(ask(worker, defaultScene()), defaultScene());
}

TEST(ProgramWorker, WritesLargeMeshesAtOnceForAProgramWithoutAUser) {
    ProgramWorker worker(When::AtOnce);
    expectProgram(ask(worker, large(70)), large(70));
    const test::NoThreads none;
    ProgramWorker alone(When::WhenReady);
    expectProgram(ask(alone, large(70)), large(70));
}

TEST(ProgramWorker, PassesOnWhatAProgramCantSay) {
    Scene scene = compressed();
    scene.textures[0].border = 1;
    ProgramWorker worker(When::AtOnce);
    const auto made = worker.program(Flavour::Glsl, scene, {}, {});
    ASSERT_TRUE(made);
    EXPECT_FALSE(*made);
}

} // namespace
} // namespace texplorer::emit::program_worker_test
