#include "texplorer/sheet/changes.h"

#include "texplorer/compare/heat_map.h"

#include <utility>

namespace texplorer::sheet {

Result<PictureChanges> changesAgainst(const Image& first, const Image& picture) {
    const Result<Difference> difference = compare(first, picture, 0, Compared::Rgb);
    if (!difference)
        return fail(difference.error());
    Result<Image> map = heatMap(first, picture, {.tolerance = 0, .top = 255}, Compared::Rgb);
    if (!map)
        return fail(map.error());
    return PictureChanges{*std::move(map), difference->over};
}

} // namespace texplorer::sheet
