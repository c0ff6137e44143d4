#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"

#include <gmock/gmock.h>
#include <imgui_internal.h> // which windows are in sight

#include <algorithm>
#include <tuple>

namespace texplorer::ui::renderer_choice_test {
namespace {

using namespace test;

class RendererChoice : public Workbench {
protected:
    /// The pixels of the live picture, as the window shows them.
    std::vector<std::byte> view() {
        static_cast<void>(picture());
        const Image window = picture(); // a new arrangement has its final layout in the second frame
        std::vector<std::byte> pixels;
        for (int y = layout.picture.y; y < layout.picture.bottom(); ++y) {
            for (int x = layout.picture.x; x < layout.picture.right(); ++x) {
                const auto pixel = window.at(x, window.height - 1 - y);
                pixels.insert(pixels.end(), pixel.begin(), pixel.begin() + 3);
            }
        }
        return pixels;
    }
};

TEST_F(RendererChoice, TheMenuBarKeysAndTheViewMenuChooseAmongThem) {
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        click("renderer:" + std::string(row.label));
        EXPECT_EQ(session->view.renderer, static_cast<RendererKind>(row.value)) << row.label;
    }
    EXPECT_FALSE(session->document.history.canUndo()) << "it is no edit of the scene";
    key('3');
    EXPECT_EQ(session->view.renderer, RendererKind::Reference);
    key('2');
    EXPECT_EQ(session->view.renderer, RendererKind::Shader);
    click("menu:View");
    click("menu:Drawn by: Fixed function");
    EXPECT_EQ(session->view.renderer, RendererKind::Fixed);
}

TEST_F(RendererChoice, TheReferenceHasTwoWaysOfAnisotropyAndBothEndsOfRho) {
    start(defaultScene(), 800, 500);
    showOne(session->view, RendererKind::Reference);
    for (const auto& [anisotropy, item] : {std::tuple(1.0F, "menu:rho of the reference: Lower end"),
                                           std::tuple(8.0F, "menu:Anisotropy of the reference: Ellipse")}) {
        texture().maxAnisotropy = anisotropy;
        const auto before = view();
        click("menu:View");
        click(item);
        EXPECT_FALSE(view() == before) << item;
    }
    EXPECT_EQ(session->view.anisotropy, reference::AnisotropyMethod::Ellipse);
    EXPECT_EQ(session->view.rho, reference::RhoMethod::Lower);
}

/// A window whose host lacks some renderers.
class FewerRenderers : public Workbench {
protected:
    void lack(std::initializer_list<RendererKind> kinds) {
        view::OfferedRenderers offered;
        for (const RendererKind kind : kinds)
            offered.withhold(kind, "the driver has none");
        std::ignore = offerRenderers(session->view, offered);
        frames(2);
    }
    /// Whether a tooltip is visible.
    [[nodiscard]] bool hasTip() const {
        const ImVector<ImGuiWindow*>& windows = ImGui::GetCurrentContext()->Windows;
        return std::any_of(windows.begin(), windows.end(), [](const ImGuiWindow* each) {
            return each->Active && !each->Hidden && (each->Flags & ImGuiWindowFlags_Tooltip) != 0;
        });
    }
};

TEST_F(FewerRenderers, WhatIsNotThereIsDimAndSaysWhy) {
    lack({RendererKind::Fixed});
    EXPECT_EQ(session->view.renderer, RendererKind::Shader);
    EXPECT_THAT(session->view.compared, testing::ElementsAre(RendererKind::Shader, RendererKind::Reference));
    click("renderer:Fixed function");
    EXPECT_EQ(session->view.renderer, RendererKind::Shader);
    EXPECT_TRUE(hasTip() || has("hint"));
    click("menu:View");
    click("menu:Drawn by: Fixed function");
    EXPECT_EQ(session->view.renderer, RendererKind::Shader);
    click("menu:Drawn by: Reference");
    EXPECT_EQ(session->view.renderer, RendererKind::Reference);
    key('1');
    EXPECT_EQ(session->view.renderer, RendererKind::Reference);
    EXPECT_THAT(session->look.notice.text, testing::HasSubstr("the driver has none"));
}

TEST_F(FewerRenderers, TwoAreComparedAndTheThirdIsNoChoice) {
    lack({RendererKind::Shader});
    EXPECT_EQ(session->view.renderer, RendererKind::Fixed);
    click("renderer:Compare");
    EXPECT_TRUE(isComparing(session->view));
    click("compared:1");
    click("compared:1=shader");
    EXPECT_EQ(session->view.compared[1], RendererKind::Reference);
    key(ui::key::escape);
    click("arrangement:Side by side");
    EXPECT_THAT(shownRenderers(session->view),
                testing::ElementsAre(RendererKind::Fixed, RendererKind::Reference));
    frames(3);
}

TEST_F(FewerRenderers, OneAloneIsNotCompared) {
    showComparison(session->view);
    lack({RendererKind::Fixed, RendererKind::Shader});
    EXPECT_FALSE(isComparing(session->view));
    click("renderer:Compare");
    key('4');
    EXPECT_FALSE(isComparing(session->view));
    EXPECT_EQ(session->view.renderer, RendererKind::Reference);
}

TEST_F(FewerRenderers, ASentenceSaysWhatGaveWay) {
    ViewSettings views;
    view::OfferedRenderers offered;
    offered.withhold(RendererKind::Shader, "its driver is too old");
    EXPECT_EQ(offerRenderers(views, offered), "") << "nothing that is shown";
    offered.withhold(RendererKind::Fixed, "its driver is too new");
    EXPECT_EQ(offerRenderers(views, offered), "Fixed function is not available: its driver is too new");
    EXPECT_EQ(offerRenderers(views, offered), "") << "once";
    EXPECT_EQ(views.renderer, RendererKind::Reference);
}

// Buttons if there is room, else a menu; and "Keep as A" next to them in every usual window.
TEST_F(RendererChoice, IsInReachAtEverySize) {
    for (const Language language : {Language::English, Language::Russian, Language::Chinese}) {
        for (const auto& [width, height, scale] :
             {std::tuple(1280, 800, 1.0F), std::tuple(1024, 700, 1.0F), std::tuple(1280, 800, 1.5F),
              std::tuple(1280, 800, 2.0F), std::tuple(1280, 800, 2.5F), std::tuple(800, 500, 1.0F)}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(language) << " " << width << " " << scale);
            start(defaultScene(), width, height, scale);
            speak(language);
            frames(3);
            if (has("renderers"))
                click("renderers");
            else if (!has("renderer:Reference")) { // Russian menus of that size fill the bar
                EXPECT_EQ(scale, 2.5F);
                click("menu:View");
            }
            click(has("renderer:Reference") ? "renderer:Reference" : "menu:Drawn by: Reference");
            EXPECT_EQ(session->view.renderer, RendererKind::Reference);
            EXPECT_TRUE(has("play"));
            EXPECT_TRUE(has("a-b row:keep") || scale > 1 || width < 1024);
            for (const auto& [name, item] : places.items) {
                const bool isInBar =
                    name.starts_with("renderer") || name.starts_with("a-b row:") || name == "speed";
                EXPECT_TRUE(!isInBar || item.right <= static_cast<float>(width)) << name;
            }
        }
    }
}

TEST_F(RendererChoice, ANarrowWindowKeepsItsMenusAndItsClock) {
    start(defaultScene(), 580, 400);
    EXPECT_FALSE(has("renderer:Shader"));
    EXPECT_TRUE(has("menu:View"));
    EXPECT_TRUE(has("play"));
}

/// All agree closely; one that does not use GL differs in some pixel.
TEST_F(RendererChoice, EachDrawsThePictureItself) {
    start(defaultScene(), 800, 500);
    std::vector<std::vector<std::byte>> pictures;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        showOne(session->view, static_cast<RendererKind>(row.value));
        pictures.push_back(view());
    }
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        ASSERT_EQ(pictures[i].size(), pictures[0].size());
        std::size_t far = 0;
        for (std::size_t at = 0; at < pictures[i].size(); ++at)
            far +=
                std::abs(std::to_integer<int>(pictures[i][at]) - std::to_integer<int>(pictures[0][at])) > 8;
        EXPECT_LT(far, pictures[i].size() / 50) << i;
    }
    EXPECT_FALSE(pictures[2] == pictures[0]);
}

} // namespace
} // namespace texplorer::ui::renderer_choice_test
