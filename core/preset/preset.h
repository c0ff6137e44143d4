#pragma once

// Presets: settings of textbook examples, as one edit each. After it, the effect is visible in any scene.

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <span>
#include <string_view>

namespace texplorer {

/// The unit that a preset edits, with the texture bound to it.
struct PresetPlace {
    std::size_t pass = 0;
    std::size_t unit = 0;

    bool operator==(const PresetPlace&) const = default;
};

/// The objects that a preset edits: they exist, and the pass and the unit are enabled.
struct PresetTarget {
    Scene& scene;
    Pass& pass;
    Unit& unit;
    Texture& texture;
    PresetPlace place;
};

struct Preset {
    std::string_view name;  ///< "alpha-test": the argument of texshot's --preset
    std::string_view group; ///< the heading in a menu; presets of a group are adjacent
    std::string_view label; ///< "Alpha test > 0.5", also the name of the undo step
    std::string_view help;  ///< what it sets
    std::string_view look;  ///< what to look at afterwards
    /// The error says what the scene has no room for.
    Result<void> (*edit)(const PresetTarget& target);
    bool cures = false; ///< it cures the mistake of a preset before it, and keeps the rest
};

/// Sorted by group, in the order of the menu.
[[nodiscard]] std::span<const Preset> presets();

/// Returns nullptr for an unknown name.
[[nodiscard]] const Preset* findPreset(std::string_view name);

/// Enables the unit, with a new texture if it has none, and applies the preset. Applying it twice changes
/// nothing more. Errors: OutOfRange if the unit does not exist, TooLarge if the scene has no room for what
/// the preset needs; the scene is then unchanged.
[[nodiscard]] Result<void> applyPreset(const Preset& preset, Scene& scene, const PresetPlace& place = {});

} // namespace texplorer
