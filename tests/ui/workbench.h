#pragma once

#include "app/ui/language/translate.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/fonts.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/window/layout.h"
#include "app/ui/window/workbench.h"
#include "texplorer/image/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string_view>

namespace texplorer::test {

/// The whole window without a display; tests provide the input. Widgets are found by the name under which
/// they record their position. Nothing is drawn until a test asks for a picture: then OSMesa draws it.
class Workbench : public testing::Test {
protected:
    Workbench();
    ~Workbench() override;

    /// Restarts with another scene or another window size.
    void start(Scene scene, int width = 1280, int height = 800, float scale = 1);
    void resize(int width, int height) {
        width_ = width;
        height_ = height;
    }

    /// Restarts with other services than the default ones, which do everything at once.
    void lend(const ui::Services& services);

    /// Sets the language of the window until the end of the test; `gaps` as in useCatalogue.
    void speak(ui::Language language, std::set<std::string, std::less<>>* gaps = nullptr);

    /// Draws frames with the pressed keys and buttons. The clock is stopped unless a test starts it.
    void frames(int count = 1);

    [[nodiscard]] bool has(std::string_view name) const { return places.items.contains(name); }
    /// The middle of a visible widget; fails the test if it is not visible.
    [[nodiscard]] ImVec2 place(std::string_view name);

    void moveTo(ImVec2 place);
    void click(std::string_view name, int button = ImGuiMouseButton_Left);
    void clickAt(ImVec2 place, int button = ImGuiMouseButton_Left);
    void doubleClickAt(ImVec2 place);
    /// Presses, moves in ten steps, releases.
    void drag(ImVec2 from, ImVec2 way, int button = ImGuiMouseButton_Left);
    void wheel(ImVec2 place, float notches);
    /// Opens a section of the parameters and scrolls there.
    void open(std::string_view section);
    /// Moves the list of vertices to the right, so that it is visible together with a tab below.
    void putListRight();
    /// Turns the wheel over the parameters until a widget is completely visible.
    void scrollTo(std::string_view name);
    void choose(std::string_view param, std::string_view name); ///< in a combo

    void setHeld(int code, bool held); ///< a key, from the next frame on
    void key(int code, std::initializer_list<int> modifiers = {});
    void type(std::string_view text);

    /// The window as OSMesa draws it: Rgba8, bottom row first. Fails the test if GL reports an error, or if
    /// the renderers report anything that the test does not expect.
    [[nodiscard]] Image picture(const testing::Matcher<std::vector<Sentence>>& problems = testing::IsEmpty());

    /// Fails the test if the last frame cannot be drawn: a vertex or a clip rectangle that is not a finite
    /// number.
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
    void rest(); ///< long enough that the next click is not a double click
    void build(const ui::Pictures& pictures);

    ui::ServicesAtOnce atOnce_;
    std::optional<ui::Services> lent_;
    int width_ = 1280;
    int height_ = 800;
    float scale_ = 1;
    std::optional<ui::Appearance> appearance_; ///< that Dear ImGui has
    std::set<int> held_;                       ///< keys
    std::unique_ptr<const ui::Catalogue> catalogue_;
    ui::Letters letters_;
    std::unique_ptr<Drawing> drawing_;
};

/// The number of pixels that no panel covers in a picture of the window.
[[nodiscard]] int pixelsOfNoPanel(const Image& picture);

constexpr int ctrl = 341; // GLFW's left control and shift keys
constexpr int shift = 340;

} // namespace texplorer::test
