#include "tests/random/layout_trial.h"

#include "app/ui/state/details_tabs.h"
#include "app/ui/state/sections.h"
#include "tests/ui/window_sizes.h"

#include <array>

namespace texplorer::random {

namespace {

using namespace ui;

struct ViewRow {
    const char* name;
    std::vector<RendererKind> renderers;
    bool magnifies = false;
};
const std::array viewRows{
    ViewRow{"fixed", {RendererKind::Fixed}},
    ViewRow{"reference", {RendererKind::Reference}},
    ViewRow{"split", {RendererKind::Fixed, RendererKind::Shader}},
    ViewRow{"side by side", {RendererKind::Fixed, RendererKind::Shader, RendererKind::Reference}},
    ViewRow{"magnified", {RendererKind::Shader}, true},
    ViewRow{"split and magnified", {RendererKind::Shader, RendererKind::Reference}, true},
};

struct SeamsRow {
    const char* name;
    Seams seams;
};
constexpr std::array seamsRows{
    SeamsRow{"usual columns", {}},
    SeamsRow{"a wide left column", {5000, 0, 0, 0}},
    SeamsRow{"a wide right column", {0, 5000, 0.99F, 0.85F}},
    SeamsRow{"narrow columns", {1, 1, 0.01F, 0.15F}},
};

struct FillingRow {
    const char* name;
    Maximised what;
};
constexpr std::array fillingRows{
    FillingRow{"nothing maximised", Maximised::None},
    FillingRow{"the view maximised", Maximised::View},
    FillingRow{"texture space maximised", Maximised::TextureSpace},
    FillingRow{"the right dock maximised", Maximised::Right},
    FillingRow{"the dock below maximised", Maximised::Below},
};

constexpr int picturesOneOf = 8; // a picture takes longer than all the rest

/// The digits of a layout's number, from the lowest on.
class Digits {
public:
    explicit Digits(int number)
        : rest_(number) {}
    template<class Rows>
    const auto& from(const Rows& rows) {
        const int size = static_cast<int>(rows.size());
        const auto& row = rows[static_cast<std::size_t>(rest_ % size)];
        rest_ /= size;
        return row;
    }

private:
    int rest_;
};

} // namespace

int LayoutTrial::count() {
    return static_cast<int>(tabRows.size() * viewRows.size() * seamsRows.size() * fillingRows.size() *
                            dockRows.size() * layoutRows.size() * test::windowScales.size() *
                            test::windowSizes.size());
}

LayoutTrial::LayoutTrial(unsigned seed, int number, Journal& journal)
    : WindowTrial(journal)
    , number_(number) {
    constexpr std::uint64_t stride = 1'000'003; // a prime: all layouts come, in an order without a rule
    Digits digits(static_cast<int>((static_cast<std::uint64_t>(number) * stride + seed) %
                                   static_cast<std::uint64_t>(count())));
    const TabRow& tab = digits.from(tabRows);
    const ViewRow& views = digits.from(viewRows);
    const SeamsRow& seams = digits.from(seamsRows);
    const FillingRow& filling = digits.from(fillingRows);
    const DockRow& dock = digits.from(dockRows);
    const LayoutRow& layoutRow = digits.from(layoutRows);
    const float scale = digits.from(test::windowScales);
    const test::WindowSize& size = digits.from(test::windowSizes);
    step(std::to_string(size.width) + " x " + std::to_string(size.height) + ", scale " +
         std::to_string(scale) + ", " + views.name + ", " + seams.name + ", " + layoutRow.label + ", " +
         filling.name + ", " + tab.label + " " + dock.label);

    start(defaultScene(), size.width, size.height, scale);
    if (views.renderers.size() == 1)
        showOne(session->view, views.renderers[0]);
    else
        showComparison(session->view, views.renderers);
    session->view.magnifies = views.magnifies;
    Workspace& workspace = session->settings.workspace;
    workspace = workspaceOf(layoutRow);
    workspace.seams = seams.seams;
    moveTab(workspace, tab.tab, dock.dock);
    workspace.maximised = filling.what;
    session->window.showRq = number % 2 == 0;
    session->look.selection.vertex = 3;
    texture().mipmaps = MipPolicy::None; // something to say in the status bar
    unit().envMode = EnvMode::Combine;
    unit().matrix = {{MatrixOp::Scale, {1, 0, 1}}};
    frames(2);
    session->look.explaining.pixel = {layout.picture.width / 2, layout.picture.height / 2};
    moveTo({static_cast<float>(layout.picture.x + layout.picture.width / 3),
            static_cast<float>(layout.picture.y + layout.picture.height / 3)});
}

void LayoutTrial::run() {
    for (const SectionRow& section : sectionRows) {
        session->out.wantedSection = section.section;
        frames(3);
        expectFilledWindow();
        expectNothingTooWide();
        expectSoundFrame();
        if (hasFailed())
            return;
    }
    if (number_ % picturesOneOf == 0) {
        step("the picture");
        expectNoGap();
    }
}

void LayoutTrial::expectFilledWindow() const {
    const std::array panels{layout.menu,      layout.parameters, layout.view,     layout.texture,
                            layout.rightDock, layout.belowDock,  layout.status,   layout.leftSeam,
                            layout.rightSeam, layout.middleSeam, layout.belowSeam};
    long long pixels = 0;
    for (const Rect& a : panels) {
        pixels += static_cast<long long>(a.width) * a.height;
        EXPECT_TRUE(a.x >= 0 && a.y >= 0 && a.width >= 0 && a.height >= 0 &&
                    a.right() <= layout.window.width && a.bottom() <= layout.window.height)
            << "a panel at " << a.x << "," << a.y << " of " << a.width << " x " << a.height;
    }
    EXPECT_EQ(pixels, static_cast<long long>(layout.window.width) * layout.window.height)
        << "panels overlap or leave something out";
}

/// What is in sight of a column's is no wider than the column, if that is as wide as the layout makes it
/// where it can. The magnifier lies above them all.
void LayoutTrial::expectNothingTooWide() const {
    struct Column {
        Rect rect;
        float least; ///< unscaled, as in layoutFor
    };
    for (const Column& column :
         {Column{layout.parameters, 272}, Column{layout.rightDock, 326}, Column{layout.belowDock, 326}}) {
        const auto left = static_cast<float>(column.rect.x);
        const auto right = static_cast<float>(column.rect.right());
        if (right - left < column.least * layout.scale)
            continue;
        for (const auto& [name, item] : places.items) {
            const float x = (item.left + item.right) / 2;
            const float y = (item.top + item.bottom) / 2;
            if (!item.visible || x < left || x >= right || y < static_cast<float>(column.rect.y) ||
                y >= static_cast<float>(column.rect.bottom()) || name.starts_with("magnifier"))
                continue;
            EXPECT_GE(item.left, left) << name;
            EXPECT_LE(item.right, right) << name;
        }
    }
}

void LayoutTrial::expectNoGap() {
    EXPECT_EQ(test::pixelsOfNoPanel(picture(testing::_)), 0);
}

} // namespace texplorer::random
