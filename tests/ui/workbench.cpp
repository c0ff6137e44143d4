#include "tests/ui/workbench.h"

#include "app/offscreen/context.h"
#include "app/opengl/opengl_graphics.h"
#include "app/stage/view_frames.h"
#include "app/ui/editor/received_files.h"
#include "app/ui/files/loads.h"
#include "app/ui/model/settle.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/theme.h"

#include <GL/glew.h>
#include <backends/imgui_impl_opengl2.h>
#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>

namespace texplorer::test {

using namespace ui;

namespace {

constexpr float frameSeconds = 1.0F / 60;

view::Capabilities madeUpCapabilities() {
    view::Capabilities capabilities;
    capabilities.renderer = "none";
    capabilities.maxTextureSize = 16384; // as OSMesa has, which draws some frames of a test
    capabilities.max3DTextureSize = 2048;
    capabilities.maxCubeMapSize = 16384;
    capabilities.textureUnits = 8;
    capabilities.maxAnisotropy = 16;
    return capabilities;
}

/// Dear ImGui's error callback for unbalanced begin and end calls.
void complain(void* /*data*/, const char* format, ...) IM_FMTARGS(2);
void complain(void* /*data*/, const char* format, ...) {
    std::array<char, 200> text{};
    std::va_list values;
    va_start(values, format);
    (void)std::vsnprintf(text.data(), text.size(), format, values);
    va_end(values);
    ADD_FAILURE() << text.data();
}

} // namespace

struct Workbench::Drawing {
    Drawing(view::Size size, const std::filesystem::path& shaders)
        : context(offscreen::Context::create(size).value())
        , graphics(opengl::OpenGlGraphics::create({shaders, {}}).value())
        , frames(*graphics) {
        graphics->startPanels();
    }
    ~Drawing() { graphics->endPanels(); }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    offscreen::Context context;
    std::unique_ptr<opengl::OpenGlGraphics> graphics;
    stage::ViewFrames frames;
};

Workbench::Workbench() {
    start(defaultScene());
}

void Workbench::start(Scene scene, int width, int height, float scale) {
    drawing_.reset();
    if (ImGui::GetCurrentContext())
        ImGui::DestroyContext();
    width_ = width;
    height_ = height;
    scale_ = scale;
    held_.clear();
    ImGui::CreateContext();
    letters_ = {};
    appearance_ = Appearance{};
    applyTheme(scale, *appearance_, catalogue_.get());
    prepareKeys();
    unsigned char* pixels = nullptr;
    int textureWidth = 0;
    int textureHeight = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &textureWidth, &textureHeight);
    states = {};
    session.emplace(lent_ ? *lent_ : atOnce_.lend(), Document{std::move(scene), ImageSource{}});
    frames(3);
}

void Workbench::lend(const ui::Services& services) {
    lent_.emplace(services);
    start(defaultScene(), width_, height_, scale_);
}

Workbench::~Workbench() {
    drawing_.reset();
    useCatalogue(nullptr);
    ImGui::DestroyContext();
}

void Workbench::build(const ui::Pictures& pictures) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width_), static_cast<float>(height_)};
    io.DeltaTime = frameSeconds;
    static const view::Capabilities madeUp = madeUpCapabilities();
    ImGui::NewFrame();
    requests = drawWorkbench(*session, states, pictures,
                             drawing_ ? drawing_->graphics->capabilities() : madeUp, layout);
    ImGui::ErrorCheckEndFrameRecover(complain);
    ImGui::Render();
    io.MouseWheel = 0;
}

void Workbench::speak(Language language, std::set<std::string, std::less<>>* gaps) {
    Result<std::unique_ptr<const Catalogue>> catalogue = catalogueOf(language);
    ASSERT_TRUE(catalogue) << describe(catalogue.error());
    useCatalogue(nullptr);
    catalogue_ = *std::move(catalogue);
    useCatalogue(catalogue_.get(), gaps);
    appearance_.reset(); // so that the fonts are built again
}

/// As the stage does before a frame.
void Workbench::layOut() {
    const Settings& settings = session->settings;
    const ImDrawData* drawn = ImGui::GetDrawData();
    const bool lacksLetters = drawn && letters_.look(*drawn);
    if (lacksLetters || appearanceOf(settings) != appearance_) {
        appearance_ = appearanceOf(settings);
        applyTheme(scale_, *appearance_, catalogue_.get(), letters_);
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        if (drawing_)
            drawing_->graphics->fontsChanged();
    }
    layout = layoutFor(width_, height_, textScale(scale_, settings.textPercent), settings.workspace,
                       gridOf(session->view), settings.largeControls);
    settle(*session, layout);
}

void Workbench::frames(int count) {
    for (int i = 0; i < count; ++i) {
        receiveFiles(*session);
        layOut();
        std::vector<ViewFrame> frames;
        for (const RendererKind renderer : shownRenderers(session->view))
            frames.push_back(
                {renderer, {{}, {layout.picture.width, layout.picture.height}, 0, {}, false}, {}});
        build({frames});
    }
}

namespace {

void clearTo(const ImVec4& color) {
    glClearColor(color.x, color.y, color.z, color.w);
    glClear(GL_COLOR_BUFFER_BIT);
}

} // namespace

Image Workbench::picture(const testing::Matcher<std::vector<Sentence>>& problems) {
    if (!drawing_)
        drawing_ = std::make_unique<Drawing>(view::Size{width_, height_}, shaders);
    layOut();
    stage::Graphics& graphics = *drawing_->graphics;
    drawing_->frames.draw(*session, {layout.picture.width, layout.picture.height});
    EXPECT_THAT(drawing_->frames.problems(), problems);
    const Texture* bound = boundTexture(std::as_const(*session));
    const view::PictureHandle texture =
        bound ? graphics.showTexture(*bound, session->document.images, session->services.levels)
              : view::PictureHandle::None;
    graphics.beginFrame();
    build({.frames = drawing_->frames.frames(),
           .difference = drawing_->frames.difference(),
           .problems = drawing_->frames.problems(),
           .shaders = drawing_->frames.shaders(),
           .texture = texture,
           .setBlending = graphics.blendingSwitch(),
           .keep =
               [&graphics](const std::shared_ptr<const Image>& image) {
                   return graphics.show(image, stage::Graphics::Use::Scaled);
               },
           .keepTexels =
               [&graphics](const std::shared_ptr<const Image>& image) {
                   return graphics.show(image, stage::Graphics::Use::Enlarged);
               }});
    glViewport(0, 0, width_, height_);
    clearTo({1, 0, 1, 1}); // a glaring colour where no panel covers the window
    glEnable(GL_SCISSOR_TEST);
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        const bool stands = window->Active && !window->Hidden && !window->ParentWindow;
        if (!stands || (window->Flags & ImGuiWindowFlags_NoBackground) == 0)
            continue;
        glScissor(static_cast<GLint>(window->Pos.x),
                  height_ - static_cast<GLint>(window->Pos.y + window->Size.y),
                  static_cast<GLsizei>(window->Size.x), static_cast<GLsizei>(window->Size.y));
        clearTo(ui::panelGround());
    }
    glDisable(GL_SCISSOR_TEST);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
    graphics.endFrame();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    Image image = Image::uninitialised(PixelFormat::Rgba8, width_, height_);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return image;
}

void Workbench::expectSoundFrame() {
    const ImDrawData* drawn = ImGui::GetDrawData();
    ASSERT_TRUE(drawn && drawn->Valid);
    const auto isFinite = [](const auto&... values) { return (std::isfinite(values) && ...); };
    for (int i = 0; i < drawn->CmdListsCount; ++i) {
        const ImDrawList& list = *drawn->CmdLists[i];
        int unsound = 0;
        for (const ImDrawVert& vertex : list.VtxBuffer)
            unsound += !isFinite(vertex.pos.x, vertex.pos.y, vertex.uv.x, vertex.uv.y);
        for (const ImDrawCmd& command : list.CmdBuffer)
            unsound +=
                !isFinite(command.ClipRect.x, command.ClipRect.y, command.ClipRect.z, command.ClipRect.w);
        EXPECT_EQ(unsound, 0) << "in the window " << (list._OwnerName ? list._OwnerName : "of no name");
    }
}

int pixelsOfNoPanel(const Image& picture) {
    int pixels = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const auto pixel = picture.at(x, y);
            pixels += pixel[0] == std::byte{255} && pixel[1] == std::byte{0} && pixel[2] == std::byte{255};
        }
    }
    return pixels;
}

ImVec2 Workbench::place(std::string_view name) {
    const auto found = places.items.find(name);
    if (found == places.items.end() || !found->second.visible) {
        ADD_FAILURE() << name << " is not in sight";
        return {-1, -1};
    }
    const ui::WidgetPlaces::Item& item = found->second;
    return {(item.left + item.right) / 2, (item.top + item.bottom) / 2};
}

void Workbench::moveTo(ImVec2 place) {
    ImGui::GetIO().MousePos = place;
    frames(2); // a widget that others may cover must have been hovered before
}

void Workbench::clickAt(ImVec2 place, int button) {
    moveTo(place);
    ImGui::GetIO().MouseDown[button] = true;
    frames(1);
    ImGui::GetIO().MouseDown[button] = false;
    frames(3);
}

void Workbench::click(std::string_view name, int button) {
    clickAt(place(name), button);
}

void Workbench::doubleClickAt(ImVec2 place) {
    clickAt(place);
    clickAt(place); // a few frames apart: well within Dear ImGui's 0.3 s
    rest();
}

void Workbench::drag(ImVec2 from, ImVec2 way, int button) {
    constexpr int steps = 10;
    moveTo(from);
    ImGuiIO& io = ImGui::GetIO();
    io.MouseDown[button] = true;
    frames(1);
    for (int i = 1; i <= steps; ++i) {
        const float share = static_cast<float>(i) / steps;
        io.MousePos = {from.x + way.x * share, from.y + way.y * share};
        frames(1);
    }
    io.MouseDown[button] = false;
    rest();
}

void Workbench::rest() {
    frames(25);
}

void Workbench::wheel(ImVec2 place, float notches) {
    moveTo(place);
    ImGui::GetIO().MouseWheel = notches;
    frames(3);
}

void Workbench::open(std::string_view section) {
    const auto row = std::ranges::find(sectionRows, section,
                                       [](const SectionRow& each) { return std::string_view(each.title); });
    ASSERT_NE(row, sectionRows.end()) << section;
    session->out.wantedSection = row->section;
    frames(1);
    session->out.wantedSection = row->section; // its place is known now
    frames(2);
}

void Workbench::putListRight() {
    moveTab(session->settings.workspace, Tab::Vertices, Dock::Right);
    frames(3);
}

void Workbench::scrollTo(std::string_view name) {
    for (const ParameterTabRow& tab : parameterTabRows) { // the tab in front may have it
        if (has(name))
            break;
        states.parameters = {tab.tab, {}};
        frames(2);
    }
    const auto panel = places.items.find("parameters");
    if (panel == places.items.end())
        return;
    const WidgetPlaces::Item room = panel->second;
    const ImVec2 above(room.left + 2, room.top + 2);
    wheel(above, 100);
    for (int turn = 0; turn < 100; ++turn) {
        const auto found = places.items.find(name);
        const bool isHead = found != places.items.end() && found->second.bottom <= room.top;
        if (isHead ||
            (found != places.items.end() && found->second.visible && found->second.bottom <= room.bottom))
            return;
        wheel(above, -1);
    }
}

void Workbench::choose(std::string_view param, std::string_view name) {
    scrollTo(param);
    const std::string choice = fmt::format("{}={}", param, name);
    if (!has(choice)) // they are in a list
        click(param);
    const std::string groups = fmt::format("{}#group ", param); // or in a submenu of it
    for (const auto& [group, item] : std::map(places.items.begin(), places.items.end())) {
        if (!has(choice) && group.starts_with(groups))
            clickAt({(item.left + item.right) / 2, (item.top + item.bottom) / 2});
    }
    click(choice);
}

void Workbench::setHeld(int code, bool held) {
    setKey(code, held);
    if (held)
        held_.insert(code);
    else
        held_.erase(code);
    setModifiers(held_.contains(ctrl), held_.contains(shift), false, false);
}

void Workbench::key(int code, std::initializer_list<int> modifiers) {
    for (const int modifier : modifiers)
        setHeld(modifier, true);
    setHeld(code, true);
    frames(1);
    setHeld(code, false);
    for (const int modifier : modifiers)
        setHeld(modifier, false);
    frames(3);
}

void Workbench::type(std::string_view text) {
    for (const char letter : text)
        addCharacter(static_cast<unsigned char>(letter));
    frames(2);
}

} // namespace texplorer::test
