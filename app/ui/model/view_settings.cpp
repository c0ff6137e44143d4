#include "app/ui/model/view_settings.h"

namespace texplorer::ui {

std::vector<RendererKind> shownRenderers(const ViewSettings& settings) {
    switch (settings.arrangement) {
    case Arrangement::One:
        return {settings.renderer};
    case Arrangement::Split:
        return {settings.compared.begin(), settings.compared.end()};
    case Arrangement::Grid:
        break;
    }
    std::vector<RendererKind> all;
    for (const EnumRow& row : EnumTable<RendererKind>::rows)
        all.push_back(static_cast<RendererKind>(row.value));
    return all;
}

void showOne(ViewSettings& settings, RendererKind renderer) {
    settings.arrangement = Arrangement::One;
    settings.renderer = renderer;
}

void showComparison(ViewSettings& settings) {
    settings.arrangement = settings.comparing;
}

void showComparison(ViewSettings& settings, const std::vector<RendererKind>& renderers) {
    settings.compared = {renderers[0], renderers[1]};
    settings.comparing = renderers.size() == 2 ? Arrangement::Split : Arrangement::Grid;
    showComparison(settings);
}

} // namespace texplorer::ui
