#include "app/ui/state/view_settings.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

std::vector<RendererKind> offeredOf(const ViewSettings& settings) {
    std::vector<RendererKind> all;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        if (settings.offered.has(static_cast<RendererKind>(row.value)))
            all.push_back(static_cast<RendererKind>(row.value));
    }
    return all;
}

} // namespace

std::vector<RendererKind> shownRenderers(const ViewSettings& settings) {
    if (!comparesRenderers(settings))
        return {settings.renderer};
    if (settings.arrangement == Arrangement::Split)
        return {settings.compared.begin(), settings.compared.end()};
    return offeredOf(settings);
}

bool canCompare(const ViewSettings& settings) {
    return offeredOf(settings).size() > 1;
}

void showOne(ViewSettings& settings, RendererKind renderer) {
    if (!settings.offered.has(renderer))
        return;
    if (comparesRenderers(settings))
        settings.arrangement = Arrangement::One;
    settings.renderer = renderer;
}

void showAsAtFirst(ViewSettings& settings) {
    const view::OfferedRenderers offered = std::exchange(settings.offered, {});
    static_cast<ShownPictures&>(settings) = {};
    static_cast<void>(offerRenderers(settings, offered));
}

void showComparison(ViewSettings& settings) {
    if (canCompare(settings))
        settings.arrangement = settings.comparing;
}

void showComparison(ViewSettings& settings, const std::vector<RendererKind>& renderers) {
    settings.compared = {renderers[0], renderers[1]};
    settings.comparing = renderers.size() == 2 ? Arrangement::Split : Arrangement::Grid;
    showComparison(settings);
}

Sentence offerRenderers(ViewSettings& settings, const view::OfferedRenderers& offered) {
    if (settings.offered == offered)
        return {};
    const std::vector<RendererKind> before = shownRenderers(settings);
    settings.offered = offered;
    const std::vector<RendererKind> all = offeredOf(settings);
    if (!offered.has(settings.renderer))
        settings.renderer = offered.best();
    for (std::size_t i = 0; i < settings.compared.size(); ++i) {
        const auto other =
            std::ranges::find_if(all, [&](RendererKind kind) { return kind != settings.compared[1 - i]; });
        if (!offered.has(settings.compared[i]))
            settings.compared[i] = other == all.end() ? all.front() : *other;
    }
    if (all.size() < 2 && comparesRenderers(settings))
        settings.arrangement = Arrangement::One;
    const auto missing = std::ranges::find_if(before, [&](RendererKind kind) { return !offered.has(kind); });
    if (missing == before.end())
        return {};
    return Sentence("{0} is not available: {1}", rowOf(*missing).label, offered.whyNot(*missing));
}

} // namespace texplorer::ui
