#pragma once

#include "app/ui/language/translate.h"
#include "app/ui/widgets/fonts.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/window/layout.h"
#include "app/ui/window/workbench.h"
#include "core/image/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string_view>

namespace texplorer::test {

/// The whole window without a window; the tests are its hands. Widgets are found by the name under which they
/// note where they are. Nothing is drawn until a test asks for a picture: then OSMesa does.
class Workbench : public testing::Test {
protected:
    Workbench();
    ~Workbench() override;

    /// Begins again with another scene or another window size.
    void start(Scene scene, int width = 1280, int height = 800, float scale = 1);

    /// Begins again with other services than those that do everything at once.
    void lend(const ui::Services& services);

    /// What the window's texts are from here on, until a test begins; `gaps` as in useCatalogue.
    void speak(ui::Language language, std::set<std::string, std::less<>>* gaps = nullptr);

    /// Draws frames, with whatever the hands hold. The clock stands still unless a test lets it run.
    void frames(int count = 1);

    [[nodiscard]] bool has(std::string_view name) const { return places.items.contains(name); }
    /// The middle of a widget that is in sight; fails the test where it isn't.
    [[nodiscard]] ImVec2 place(std::string_view name);

    void moveTo(ImVec2 place);
    void click(std::string_view name, int button = ImGuiMouseButton_Left);
    void clickAt(ImVec2 place, int button = ImGuiMouseButton_Left);
    void doubleClickAt(ImVec2 place);
    /// Presses, moves in ten steps, lets go.
    void drag(ImVec2 from, ImVec2 way, int button = ImGuiMouseButton_Left);
    void wheel(ImVec2 place, float notches);
    /// Opens a section of the parameters and scrolls there.
    void open(std::string_view section);
    /// The list of vertices on the right, where one may drag it: so it is in sight beside a tab below.
    void putListRight();
    /// Turns the wheel over the parameters until a widget is whole in sight.
    void scrollTo(std::string_view name);
    void choose(std::string_view param, std::string_view name); ///< in a combo

    void setHeld(int code, bool held); ///< a key, from the next frame on
    void key(int code, std::initializer_list<int> modifiers = {});
    void type(std::string_view text);

    /// The window as OSMesa draws it: Rgba8, bottom row first. Fails the test where GL reports anything, or
    /// the renderers say anything else than what the test expects of them.
    [[nodiscard]] Image
    picture(const testing::Matcher<std::vector<std::string>>& problems = testing::IsEmpty());

    /// Fails the test where what was drawn last is nothing that can be drawn: a vertex or a clip rectangle
    /// that isn't a finite number.
    static void expectSoundFrame();

    [[nodiscard]] Scene& scene() { return session->document.scene; }
    [[nodiscard]] Texture& texture() { return session->document.scene.textures.front(); }
    [[nodiscard]] Unit& unit() { return session->document.scene.passes.front().units.front(); }

    std::filesystem::path
        shaders; ///< of the shader renderer, before the first picture; empty: the built-in ones
    ui::WidgetPlaces places;
    std::optional<ui::Session> session;
    ui::PanelStates states;
    ui::Requests requests;
    ui::Layout layout;

private:
    struct Drawing;

    void layOut();
    void rest(); ///< so long that the next click is no second one
    void build(const ui::Pictures& pictures);

    ui::ServicesAtOnce atOnce_;
    std::optional<ui::Services> lent_;
    int width_ = 1280;
    int height_ = 800;
    float scale_ = 1;
    int textPercent_ = 100; ///< with the theme, what Dear ImGui was set up for
    std::set<int> held_;    ///< keys
    ui::Theme theme_ = ui::Theme::Dark;
    std::unique_ptr<const ui::Catalogue> catalogue_;
    ui::Letters letters_;
    std::unique_ptr<Drawing> drawing_;
};

/// Of a picture of the window: how many pixels no panel covers.
[[nodiscard]] int pixelsOfNoPanel(const Image& picture);

constexpr int ctrl = 341; // GLFW's left control and shift keys
constexpr int shift = 340;

} // namespace texplorer::test
