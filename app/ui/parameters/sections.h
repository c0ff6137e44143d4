#pragma once

// The sections of the panel, and their parts: each draws the rows of what is selected.

#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/pictures.h"

#include <memory>
#include <string>
#include <vector>

namespace texplorer::ui {

/// The most important parameters, one click each, and below them the rows that the user has pinned.
void essentials(const Session& session, const Pictures& pictures);

/// Draws the usual degrees of anisotropy as buttons, and a slider up to the driver's limit.
void anisotropyLine(const Session& session, const Owner& texture, const ParamRow& row);

/// The end of the slider: the driver's maximum, or, if it has none, that of the reference renderer, which is
/// the row's.
[[nodiscard]] float maxAnisotropyOf(float driver, const ParamRow& row);

/// The texture bound to the selected unit.
void textureSection(const Session& session, const Pictures& pictures);

/// The built-in patterns as small pictures, next to them the texture's previous image file, and a button that
/// opens one. For the bound texture, which must exist.
void imageChoice(const Session& session, const Pictures& pictures);

/// The equation of the selected unit's environment, and its input and output colours, for the probed pixel or
/// for reference colours: glColor and the mean of the image. Uses the previewed scene, if any.
void environmentLine(const Session& session);

void combineSection(const Session& session);     ///< of the selected unit, whose mode is GL_COMBINE
void coordinatesSection(const Session& session); ///< generated ones, of the selected unit

/// The steps of the selected unit's texture matrix.
void matrixSection(const Session& session);

/// How many steps it has with the selected model: those that earlier passes left, the pass's, the model's.
[[nodiscard]] std::size_t matrixStepCount(const Session& session);

/// The presets that move the texture, one click each, and a button that adds a step.
void motionButtons(const Session& session);

/// Buttons to select the pass whose units and state are shown; a dot marks those that are drawn. Does nothing
/// if there is one pass.
void passChoice(const Session& session);

/// The passes: add, remove, reorder; and the state of the selected one.
void passSection(const Session& session);

/// The selected model: the choice, number and order of models, and its rows of the tables.
void modelSection(const Session& session);

// The lists of a texture: the steps of its preparation, each with its resulting picture, and its individual
// levels, each with its picture and size. `summary` has the pictures made so far; nullptr: none yet.
void preparationList(const Session& session, std::size_t texture, const LevelsSummary* summary,
                     const Pictures& pictures);
void levelList(const Session& session, std::size_t texture, const LevelsSummary* summary,
               const Pictures& pictures);
void subimageList(const Session& session, std::size_t texture);

/// Whether a value may be set at once. A source without a file asks for one; a file that is not loaded is
/// read first. `owner` is the path of the object that names it, `file` its current name.
[[nodiscard]] bool acceptsFile(const Session& session, const std::string& owner, const std::string& file,
                               const ParamRow& row, const Value& value);

/// Draws the units of the selected pass in a row, each with its texture and its switch, to select, enable and
/// disable them. Below it, what an edit of the texture affects.
void unitBar(const Session& session, const Pictures& pictures);

/// Enables or disables a unit of the selected pass. A unit that is enabled for the first time, or has no
/// texture, gets its own texture with another pattern.
void switchUnit(const Session& session, int unit, bool on);

/// The edits that add a texture with this pattern and bind it to a unit of the selected pass.
[[nodiscard]] std::vector<Edit> addedTexture(const Session& session, int unit, Pattern pattern);

/// "unit 0, unit 2 of pass 1": units that are on and show the texture of a unit of the selected pass.
[[nodiscard]] Sentence sharersText(const Session& session, int unit);

/// A struct whose rows the parameters show.
struct ShownStruct {
    Section section;
    Sentence title; ///< "Generated s", if its section has several
    Owner owner;
    const StructTable* table;
};

/// All structs of the selection, in the order of the tabs. Valid until the next edit of a list in the scene.
[[nodiscard]] std::vector<ShownStruct> shownStructs(const Session& session);

/// Those of one section.
[[nodiscard]] std::vector<ShownStruct> shownStructs(const Session& session, Section section);

/// The structs that panels edit by their rows.
[[nodiscard]] Owner textureOwner(const Session& session); ///< of the bound one, which there must be
[[nodiscard]] Owner unitOwner(const Session& session);
[[nodiscard]] Owner materialOwner(const Session& session);

/// The largest level, small and upright; nullptr: not ready, or there is none.
[[nodiscard]] std::shared_ptr<const Image> thumbnailOf(const Session& session, const Texture& texture,
                                                       Target target);

/// The name of the image in lists: "Brick wall", "earth.jpg".
[[nodiscard]] Sentence nameOfImage(const Texture& texture);

} // namespace texplorer::ui
