#pragma once

// Edits of a scene as values: what lessons, suites, fixes of findings and the buttons of lists do.

#include "texplorer/base/result.h"
#include "texplorer/preset/preset.h"
#include "texplorer/scene/scene.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace texplorer {

namespace edit {

/// Sets a parameter, as setParam: "textures[0].wrapS" to "GL_CLAMP".
struct Set {
    std::string path;
    std::string value;

    bool operator==(const Set&) const = default;
};

/// Inserts an element before the one with this index, or at the end: a new one, or a copy of another.
struct Insert {
    std::string list; ///< "textures", "passes[0].units[1].matrix"
    std::size_t index = 0;
    std::optional<std::size_t> copyOf{};

    bool operator==(const Insert&) const = default;
};

struct Remove {
    std::string list;
    std::size_t index = 0;

    bool operator==(const Remove&) const = default;
};

/// Moves an element to another index; the elements between move by one.
struct Move {
    std::string list;
    std::size_t from = 0;
    std::size_t to = 0;

    bool operator==(const Move&) const = default;
};

struct ApplyPreset {
    std::string name; ///< "alpha-test"
    PresetPlace place{};

    bool operator==(const ApplyPreset&) const = default;
};

/// Copies the values at some paths from another scene, as takeOver, or the whole scene.
struct Replace {
    std::shared_ptr<const Scene> from;
    std::vector<std::string> paths{}; ///< empty: the whole scene

    bool operator==(const Replace&) const = default;
};

} // namespace edit

using Edit =
    std::variant<edit::Set, edit::Insert, edit::Remove, edit::Move, edit::ApplyPreset, edit::Replace>;

/// The edit that makes the changes of a function; nullopt if it changes nothing. The function gets a copy of
/// the scene. It must not remove textures, models or passes, which others name by their index. The key frames
/// of other removed elements are removed.
[[nodiscard]] std::optional<Edit> editThat(const Scene& scene, const std::function<void(Scene&)>& change);

/// Makes all edits, or, if one is not possible, none. After Insert, Remove and Move everything that names an
/// element of the list by its index names the same element (references.h). The error's `where` begins with
/// `pointer`, if one is given, and the number of the edit, "/edits/2". Errors: of setParam and applyPreset;
/// NotFound: no such preset; OutOfRange: no such list or element; TooLarge: the list is full, or has no
/// element more than it needs. Edited vertices of a file become the scene's own (takeVertices).
[[nodiscard]] Result<void> makeEdits(Scene& scene, std::span<const Edit> edits,
                                     std::string_view pointer = {});

/// When edits are made in a scene with key frames.
struct EditTime {
    double shown = 0; ///< seconds: the values at this time are seen and edited
    float key = 0;    ///< seconds: where a new key is set
};

/// The same at a time: an edit of a parameter with key frames leaves its value and sets a key there, unless
/// the whole scene is replaced. A copied element has the values that are seen. Returns whether a key was set.
/// Errors: those of putKey as well.
[[nodiscard]] Result<bool> makeEditsAt(Scene& scene, std::span<const Edit> edits, EditTime time);

/// An edit in a file: "textures[0].wrapS=GL_CLAMP" or "preset:alpha-test"; nullopt for anything else.
[[nodiscard]] std::optional<Edit> parseEdit(std::string_view text);

/// The inverse; empty for edits that files cannot contain.
[[nodiscard]] std::string textOf(const Edit& edit);

/// The only path that an edit sets or replaces; empty for other edits.
[[nodiscard]] std::string_view pathOf(const Edit& edit);

} // namespace texplorer
