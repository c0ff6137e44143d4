#include "tests/core/diagnosis/mistakes.h"

namespace texplorer::test {
namespace {

using enum Severity;

/// Pass 0 draws the picture that pass 1 shows.
void showPicture(Subject& s) {
    s.texture().source = SourceKind::Picture;
    s.scene.passes.push_back(s.pass());
    s.pass().picture = 1;
    for (Unit& unit : s.pass().units)
        unit.enabled = false;
}

constexpr std::array pictureRows{
    Mistake{"SubimageBeyondTheLevel", "subimage-refused", Warning, "textures[0].subimages[0]",
            "the columns 250 to", [](Subject& s) { s.texture().subimages = {{.x = 250}}; },
            [](Subject& s) { s.texture().subimages[0].x = 0; }},
    Mistake{"SubimageOfALevelThatIsMissing", "subimage-refused", Warning, "textures[0].subimages[1]",
            "there is no level 9",
            [](Subject& s) {
                s.texture().subimages = {{}, {.level = 9}};
            },
            [](Subject& s) { s.texture().subimages[1].level = 0; }},
    Mistake{"SubimageWithoutItsFile", "missing-part", Error, "textures[0].subimages[0].file",
            "an image file is needed, but none is named: nothing is replaced",
            [](Subject& s) { s.texture().subimages = {{.source = SourceKind::File}}; },
            [](Subject& s) { s.texture().subimages[0].source = SourceKind::Pattern; }},
    Mistake{"NothingInTheWindow", "empty-window", Warning, "passes[0].picture", "draws in the window",
            [](Subject& s) { s.pass().picture = 2; }},
    Mistake{"PictureThatNothingDraws", "picture-not-drawn", Warning, "textures[0].picture", "picture 3",
            [](Subject& s) {
                showPicture(s);
                s.texture().picture = 3;
            },
            [](Subject& s) { s.texture().picture = 1; }},
    Mistake{"PictureOfItself", "unfinished-picture", Warning, "textures[0].frames", "no frame before",
            [](Subject& s) {
                showPicture(s);
                s.unit().enabled = true;
            }},
    Mistake{"PictureThatNothingShows", "picture-not-shown", Hint, "passes[1].picture",
            "no unit shows picture 5",
            [](Subject& s) {
                s.scene.passes.push_back(s.pass());
                s.scene.passes[1].picture = 5;
            }},
    Mistake{"PictureOfAPattern", "other-texture-choice", Unused, "textures[0].pictureSize", "Built-in",
            [](Subject&) {}, [](Subject& s) { s.texture().source = SourceKind::Picture; }},
    Mistake{"SizeOfAFile", "other-texture-choice", Unused, "textures[0].subimages[0].width", "Image file",
            [](Subject& s) { s.texture().subimages = {{.source = SourceKind::File}}; },
            [](Subject& s) { s.texture().subimages[0].source = SourceKind::Pattern; }},
    Mistake{"FlippedPicture", "texture-setting", Hint, "textures[0].flip", "is upright", showPicture,
            [](Subject& s) { s.showFile(4, 4); }},
    Mistake{"UploadedPicture", "texture-setting", Hint, "textures[0].upload", "draws or copies",
            [](Subject& s) {
                showPicture(s);
                s.texture().upload.custom = true;
            },
            [](Subject& s) { s.texture().source = SourceKind::Pattern; }},
};

} // namespace

std::span<const Mistake> pictureMistakes() {
    return pictureRows;
}

} // namespace texplorer::test
