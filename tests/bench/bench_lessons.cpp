// How long a lesson takes to open: from the click to the first frame with the picture of its first step. The
// small pictures of answers, which are drawn in the background, are not waited for. Each time in a new
// context in which the default scene was drawn: llvmpipe compiles the filters of the lesson again.

#include "app/offscreen/context.h"
#include "app/opengl/opengl_graphics.h"
#include "app/stage/stage.h"
#include "app/ui/editor/received_files.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/loads.h"
#include "texplorer/lesson/lesson_files.h"

#include <GL/glew.h>
#include <benchmark/benchmark.h>

namespace texplorer::bench {
namespace {

constexpr view::Size lessonWindow{1280, 800};

void lessonOpens(benchmark::State& state, const std::string& name) {
    const stage::Surface surface{lessonWindow, lessonWindow, 1};
    for (auto _ : state) {
        state.PauseTiming();
        {
            const auto context = offscreen::Context::create(lessonWindow);
            const auto graphics = opengl::OpenGlGraphics::create();
            if (!graphics)
                return state.SkipWithError(describe(graphics.error()).english().c_str());
            stage::Stage stage(**graphics, 1);
            ui::ServicesAtOnce atOnce;
            ui::LessonWork beside(When::WhenReady);
            const ui::Services all = atOnce.lend();
            ui::Session session(ui::Services{all.files, all.levels, all.reference, all.kept, all.probe,
                                             all.levelMap, all.patterns, all.levelPictures, beside,
                                             all.environments, all.plainProbe, all.sheet, all.programs,
                                             all.writing});
            stage.draw(session, surface, 1.0F / 60);
            glFinish();
            state.ResumeTiming();
            const Result<void> opened = ui::openLessonNamed(session, name, 0);
            (void)ui::receiveFiles(session);
            stage.draw(session, surface, 1.0F / 60);
            glFinish();
            state.PauseTiming();
            if (!opened)
                state.SkipWithError(describe(opened.error()).english().c_str());
        }
        state.ResumeTiming();
    }
}

const bool lessonsRegistered = [] {
    for (const std::string& name : lesson::builtInLessons()) {
        benchmark::RegisterBenchmark(("lessonOpens/" + name).c_str(),
                                     [name](benchmark::State& state) { lessonOpens(state, name); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->Iterations(1);
    }
    return true;
}();

} // namespace
} // namespace texplorer::bench
