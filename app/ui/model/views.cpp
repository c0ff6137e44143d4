#include "app/ui/model/views.h"

namespace texplorer::ui {

std::vector<RendererKind> shownRenderers(const Views& views) {
    switch (views.arrangement) {
    case Arrangement::One:
        return {views.renderer};
    case Arrangement::Split:
        return {views.compared.begin(), views.compared.end()};
    case Arrangement::Grid:
        break;
    }
    std::vector<RendererKind> all;
    for (const EnumRow& row : EnumTable<RendererKind>::rows)
        all.push_back(static_cast<RendererKind>(row.value));
    return all;
}

void showOne(Views& views, RendererKind renderer) {
    views.arrangement = Arrangement::One;
    views.renderer = renderer;
}

void showComparison(Views& views) {
    views.arrangement = views.comparing;
}

void showComparison(Views& views, const std::vector<RendererKind>& renderers) {
    views.compared = {renderers[0], renderers[1]};
    views.comparing = renderers.size() == 2 ? Arrangement::Split : Arrangement::Grid;
    showComparison(views);
}

} // namespace texplorer::ui
