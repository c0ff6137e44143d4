#include "app/ui/model/sheet_choice.h"

#include "app/ui/model/session.h"
#include "texplorer/reference/shading/environment_table.h"
#include "texplorer/scene/params/keys.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

std::string boundTexturePath(const Session& session, const std::string& key) {
    const auto bound = static_cast<std::size_t>(std::max(0, selectedUnit(session).texture));
    return elementOf<&Scene::textures>(bound) + "." + key;
}

template<class Enums>
std::string namesOf(const Enums& values) {
    std::string names;
    for (const auto value : values)
        names += (names.empty() ? "" : ",") + std::string(texplorer::rowOf(value).name);
    return names;
}

} // namespace

const std::array<SheetPair, 4>& sheetPairs() {
    static const std::array<SheetPair, 4> pairs{
        SheetPair{
            "filters", N_("Filter laboratory"), N_("Minification: six filters, with one to sixteen samples."),
            [](const Session& session) {
                return SheetAxes{
                    SheetAxis{boundTexturePath(session, keyOf<&Texture::maxAnisotropy>()), "1,2,4,8,16"},
                    SheetAxis{boundTexturePath(session, keyOf<&Texture::minFilter>()), "*"}};
            }},
        SheetPair{"magnification", N_("Both filters"), N_("The magnification and the minification filter."),
                  [](const Session& session) {
                      return SheetAxes{
                          SheetAxis{boundTexturePath(session, keyOf<&Texture::magFilter>()), "*"},
                          SheetAxis{boundTexturePath(session, keyOf<&Texture::minFilter>()), "*"}};
                  }},
        SheetPair{"wraps", N_("Both wraps"),
                  N_("What is shown beyond the image's edges, in both directions."),
                  [](const Session& session) {
                      return SheetAxes{SheetAxis{boundTexturePath(session, keyOf<&Texture::wrapT>()), "*"},
                                       SheetAxis{boundTexturePath(session, keyOf<&Texture::wrapS>()), "*"}};
                  }},
        SheetPair{"environments", N_("Environments"),
                  N_("How the unit combines fragment and texel, for each base format."),
                  [](const Session& session) {
                      return SheetAxes{SheetAxis{selectedUnitPath(session) + "." + keyOf<&Unit::envMode>(),
                                                 namesOf(reference::tableModes)},
                                       SheetAxis{boundTexturePath(session, keyOf<&Texture::internalFormat>()),
                                                 namesOf(reference::tableFormats)}};
                  }},
    };
    return pairs;
}

SheetAxes axesOf(const Session& session) {
    const SheetChoice& choice = session.sheet;
    if (choice.own)
        return *choice.own;
    SheetAxes axes = sheetPairs().at(choice.pair).axes(session);
    if (choice.swapped)
        std::swap(axes[0], axes[1]);
    return axes;
}

Result<std::array<SweepAxis, 2>> sweptAxes(const Session& session) {
    std::array<SweepAxis, 2> swept;
    const SheetAxes axes = axesOf(session);
    for (std::size_t side = 0; side < swept.size(); ++side) {
        Result<SweepAxis> axis = sweepAxis(presentScene(session), axes[side].path, axes[side].values);
        if (!axis)
            return fail(axis.error());
        swept[side] = *std::move(axis);
    }
    if (swept[0].path == swept[1].path)
        return fail(ErrorCode::Unsupported,
                    "rows and columns are the same parameter: choose another one for either");
    return swept;
}

void varyOnSheet(Session& session, std::string path, std::size_t side) {
    SheetAxes axes = axesOf(session);
    if (axes[1 - side].path == path)
        std::swap(axes[0], axes[1]);
    else if (axes[side].path != path)
        axes[side] = {std::move(path)};
    session.sheet.own = std::move(axes);
    showSheet(session);
}

void showSheet(Session& session) {
    session.window.figure = Figure::Sheet;
    session.window.wantedTab = Tab::Figures;
}

} // namespace texplorer::ui
