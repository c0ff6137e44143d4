// What the panels add to a frame of the window: the whole frame against the renderer alone, at the size of
// the picture in the window; a frame while coordinates are dragged; and frames with figures that work in the
// background.

#include "app/offscreen/context.h"
#include "app/opengl/opengl_graphics.h"
#include "app/stage/stage.h"
#include "app/ui/model/playback.h"
#include "app/ui/widgets/widget_places.h"

#include <GL/glew.h>
#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <imgui.h>

#include <optional>

namespace texplorer::bench {
namespace {

constexpr view::Size window{1280, 800};

void windowFrame(benchmark::State& state) {
    const auto context = offscreen::Context::create(window);
    const auto graphics = opengl::OpenGlGraphics::create();
    if (!graphics)
        return state.SkipWithError(describe(graphics.error()).english().c_str());
    stage::Stage stage(**graphics, 1);
    ui::ServicesAtOnce services;
    ui::Session session(services.lend());
    for (auto _ : state) {
        stage.draw(session, {window, window, 1}, 1.0F / 60);
        glFinish();
    }
}

/// The default window with a single sphere of 128 x 64. The mouse drags one of its vertices back and forth in
/// texture space: each frame has other coordinates, an edit in the history and a diagnosis.
void windowDrag(benchmark::State& state) {
    const auto context = offscreen::Context::create(window);
    const auto graphics = opengl::OpenGlGraphics::create();
    if (!graphics)
        return state.SkipWithError(describe(graphics.error()).english().c_str());
    stage::Stage stage(**graphics, 1);
    ui::ServicesAtOnce services;
    ui::Session session(services.lend());
    Scene& scene = session.document.scene;
    scene.models.erase(scene.models.begin());
    scene.models.front().slices = 128;
    scene.models.front().stacks = 64;
    constexpr std::size_t vertex = 4000;
    session.look.selection.vertex = vertex;
    const auto draw = [&](ImVec2 mouse, bool pressed) {
        stage.draw(session, {window, window, 1}, 1.0F / 60, [&] {
            ImGui::GetIO().MousePos = mouse;
            ImGui::GetIO().MouseDown[ImGuiMouseButton_Left] = pressed;
        });
        glFinish();
    };
    ImVec2 mouse;
    {
        const ui::WidgetPlaces places;
        draw({}, false);
        const ui::WidgetPlaces::Item& place = places.items.at(fmt::format("end:{}", vertex));
        mouse = {place.left, place.top};
    }
    draw(mouse, false);
    draw(mouse, true);
    int frame = 0;
    for (auto _ : state) {
        constexpr int there = 100;
        const int way = frame++ % (2 * there);
        draw({mouse.x + static_cast<float>(10 + (way < there ? way : 2 * there - way)), mouse.y}, true);
    }
    if (session.document.scene.models.front().texCoords[0].empty())
        state.SkipWithError("the mouse moved no vertex");
}

/// Whether the scene moves while a figure is shown.
enum class Moves { No, Yes };

/// The default window with a figure below, or without one. Its workers run in the background, as for a user.
/// If the scene moves, the probed pixel has other colours in each frame, and the pictures of the sheet are
/// drawn again.
void figureFrame(benchmark::State& state, std::optional<ui::Figure> figure, Moves moves) {
    const auto context = offscreen::Context::create(window);
    const auto graphics = opengl::OpenGlGraphics::create();
    if (!graphics)
        return state.SkipWithError(describe(graphics.error()).english().c_str());
    stage::Stage stage(**graphics, 1);
    ui::ServicesBeside services;
    ui::Session session(services.lend());
    if (moves == Moves::Yes) {
        for (Model& model : session.document.scene.models)
            model.spin = {0, 30, 0};
    }
    if (figure) {
        session.window.figure = *figure;
        session.window.wantedTab = ui::Tab::Figures;
    }
    const auto draw = [&] {
        ui::advance(session, 1.0 / 60);
        stage.draw(session, {window, window, 1}, 1.0F / 60);
        glFinish();
    };
    for (int i = 0; i < 3; ++i)
        draw();
    session.look.explaining.pixel = {150, 200};
    draw();
    if (moves == Moves::No) // until everything is drawn
        session.services.sheet->wait();
    for (auto _ : state)
        draw();
}

BENCHMARK(windowFrame)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(windowDrag)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(figureFrame, none, std::nullopt, Moves::No)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(figureFrame, environments, ui::Figure::Environments, Moves::No)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(figureFrame, sheet, ui::Figure::Sheet, Moves::No)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(figureFrame, noneMoving, std::nullopt, Moves::Yes)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(figureFrame, environmentsMoving, ui::Figure::Environments, Moves::Yes)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(figureFrame, sheetMoving, ui::Figure::Sheet, Moves::Yes)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace texplorer::bench
