#pragma once

// Presets: what a textbook shows of a setting, as one edit. Whatever a scene was before, after it there is
// something to see.

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <span>
#include <string_view>

namespace texplorer {

/// The unit that a preset is about. Its texture is the one that is bound to it.
struct PresetPlace {
    std::size_t pass = 0;
    std::size_t unit = 0;
};

/// What a preset edits: everything is there, and the pass and the unit are on.
struct PresetTarget {
    Scene& scene;
    Pass& pass;
    Unit& unit;
    Texture& texture;
    PresetPlace place;
};

struct Preset {
    std::string_view name;  ///< "alpha-test": for texshot's --preset
    std::string_view group; ///< its caption in a menu; those of a group follow one another
    std::string_view label; ///< "Alpha test > 0.5", of the step of undo, too
    std::string_view help;  ///< what it sets
    std::string_view look;  ///< what there is to see afterwards
    /// The error says what there is no room for.
    Result<void> (*edit)(const PresetTarget& target);
};

/// Those of a group together, in the order of a menu.
[[nodiscard]] std::span<const Preset> presets();

/// nullptr: there is none of this name.
[[nodiscard]] const Preset* findPreset(std::string_view name);

/// Switches the unit on, with a texture where it has none, and does what the preset says. Once more changes
/// nothing. Errors: OutOfRange where there is no such unit, TooLarge where the scene has no room for what it
/// needs; the scene is then what it was before.
[[nodiscard]] Result<void> applyPreset(const Preset& preset, Scene& scene, const PresetPlace& place = {});

} // namespace texplorer
