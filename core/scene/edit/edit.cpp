#include "texplorer/scene/edit/edit.h"

#include "texplorer/scene/mesh_edits.h"
#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_at.h"
#include "texplorer/scene/params/scene_diff.h"
#include "texplorer/scene/references.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer {
namespace {

constexpr std::string_view presetWord = "preset:";

tl::unexpected<Error> noElement(const ListAt& list, std::string_view path, std::size_t found) {
    return fail(
        ErrorCode::OutOfRange,
        Sentence("expected the index of one of {0} elements, counted from 0, found {1}", list.size(), found),
        std::string(path));
}

/// A list whose elements can be inserted, removed and moved; it must have elements with these indices.
Result<ListAt> variableListAt(Scene& scene, const std::string& path,
                              std::initializer_list<std::size_t> indices = {}) {
    Result<ListAt> list = listAt(scene, path);
    if (list && !list->row->insert)
        return fail(ErrorCode::OutOfRange,
                    Sentence("it always has {0} elements, in this order", list->size()), path);
    for (const std::size_t index : indices) {
        if (list && index >= list->size())
            return noElement(*list, path, index);
    }
    return list;
}

Result<void> make(Scene& scene, const edit::Set& set) {
    return setParam(scene, set.path, set.value);
}

/// A copied element is one of `shown`, which has the same lists; nullptr: of the scene.
Result<void> make(Scene& scene, const edit::Insert& insert, Scene* shown = nullptr) {
    const Result<ListAt> list = variableListAt(scene, insert.list);
    if (!list)
        return fail(list.error());
    if (list->size() >= list->row->maxCount)
        return fail(ErrorCode::TooLarge, Sentence("it already has {0} elements", list->size()), insert.list);
    if (insert.index > list->size())
        return noElement(*list, insert.list, insert.index);
    if (insert.copyOf && *insert.copyOf >= list->size())
        return noElement(*list, insert.list, *insert.copyOf);
    const Result<ListAt> copied = variableListAt(shown ? *shown : scene, insert.list);
    list->row->insert(list->owner, insert.index,
                      insert.copyOf && copied ? copied->row->at(copied->owner, *insert.copyOf) : nullptr);
    renumber(scene, insert.list, afterInsert(insert.index));
    return {};
}

Result<void> make(Scene& scene, const edit::Remove& remove) {
    const Result<ListAt> list = variableListAt(scene, remove.list, {remove.index});
    if (!list)
        return fail(list.error());
    if (list->size() <= list->row->minCount)
        return fail(ErrorCode::TooLarge, Sentence("it needs {0} elements", list->row->minCount), remove.list);
    list->row->erase(list->owner, remove.index);
    renumber(scene, remove.list, afterRemove(remove.index));
    return {};
}

Result<void> make(Scene& scene, const edit::Move& move) {
    const Result<ListAt> list = variableListAt(scene, move.list, {move.from, move.to});
    if (!list)
        return fail(list.error());
    list->row->move(list->owner, move.from, move.to);
    renumber(scene, move.list, afterMove(move.from, move.to));
    return {};
}

Result<void> make(Scene& scene, const edit::ApplyPreset& apply) {
    const Preset* preset = findPreset(apply.name);
    if (!preset)
        return fail(ErrorCode::NotFound, "there is no such preset", apply.name);
    return applyPreset(*preset, scene, apply.place);
}

/// Removes the elements of a list that it does not have in `from`, with their key frames. Returns false if
/// the path is of something else, the list is not longer, or others name its elements (textures, models,
/// passes).
Result<bool> shorten(Scene& scene, Scene& from, const std::string& path) {
    const Result<ListAt> list = listAt(scene, path);
    const Result<ListAt> wanted = listAt(from, path);
    const bool isInside = path.find('.') != std::string::npos;
    if (!isInside || !list || !wanted || !list->row->insert || list->size() <= wanted->size())
        return false;
    for (std::size_t last = list->size(); last > wanted->size(); --last) {
        if (Result<void> removed = make(scene, edit::Remove{path, last - 1}); !removed)
            return fail(removed.error());
    }
    return true;
}

Result<void> make(Scene& scene, const edit::Replace& replace) {
    if (replace.paths.empty()) {
        scene = *replace.from;
        return {};
    }
    Scene from = *replace.from; // listAt takes what may be written
    std::vector<std::string> rest;
    for (const std::string& path : replace.paths) {
        const Result<bool> shortened = shorten(scene, from, path);
        if (!shortened)
            return fail(shortened.error());
        if (!*shortened)
            rest.push_back(path);
    }
    return takeOver(scene, from, rest);
}

/// Whether it may set parameters that have key frames.
bool setsValues(const Edit& edit) {
    const auto* replace = std::get_if<edit::Replace>(&edit);
    const auto* set = std::get_if<edit::Set>(&edit); // a new element has no keys
    return (set && set->path.find(newElement) == std::string::npos) ||
           std::holds_alternative<edit::ApplyPreset>(edit) || (replace && !replace->paths.empty());
}

/// Whether it copies values, but no key frames.
bool leavesTimeline(const Edit& edit) {
    const auto* replace = std::get_if<edit::Replace>(&edit);
    return replace && std::ranges::none_of(replace->paths, [](const std::string& path) {
               return path.starts_with(keyOf<&Scene::timeline>());
           });
}

Result<void> makeOne(Scene& scene, const Edit& edit) {
    return std::visit([&](const auto& each) { return make(scene, each); }, edit);
}

/// Whether edits have changed the vertices of a file, or given them other coordinates. A file that they name
/// is read later.
bool isEdited(const Model& model, const std::vector<Model>& before) {
    const MeshData& mesh = model.mesh;
    if (model.shape != Shape::Mesh || mesh.file.empty() || mesh.positions.empty())
        return false;
    const auto hasSameFile = [&](const Model& each) {
        return each.mesh.file == mesh.file && each.mesh.part == mesh.part;
    };
    const auto isSame = [&](const Model& each) {
        return each.mesh.positions == mesh.positions && each.mesh.normals == mesh.normals &&
               each.mesh.colors == mesh.colors && each.mesh.texCoords == mesh.texCoords &&
               each.mesh.indices == mesh.indices && each.texCoords == model.texCoords &&
               each.noTexCoord == model.noTexCoord;
    };
    return std::ranges::any_of(before, hasSameFile) && std::ranges::none_of(before, isSame);
}

/// Vertices that were edited are the scene's own.
Result<void> takeEdited(Scene& made, const Scene& before) {
    for (Model& model : made.models)
        if (isEdited(model, before.models))
            if (Result<void> taken = takeVertices(model.mesh); !taken)
                return taken;
    return {};
}

/// Returns whether a key was set.
Result<bool> makeOneAt(Scene& scene, const Edit& edit, EditTime time) {
    const auto* insert = std::get_if<edit::Insert>(&edit);
    const bool copies = insert && insert->copyOf;
    const auto withoutKey = [] { return false; };
    if (scene.timeline.keys.empty() || !(copies || setsValues(edit)))
        return makeOne(scene, edit).map(withoutKey);
    Scene shown = sceneAt(scene, time.shown);
    if (copies)
        return make(scene, *insert, &shown).map(withoutKey);
    shown.timeline = scene.timeline;
    Scene edited = shown;
    if (Result<void> done = makeOne(edited, edit); !done)
        return fail(done.error());
    if (leavesTimeline(edit))
        shown.timeline = edited.timeline; // without the keys of removed elements
    const Result<bool> set = keyEdits(edited, shown, time.key);
    if (!set)
        return fail(set.error().code, Sentence("a key frame can't be added: {0}", describe(set.error())));
    putUnkeyed(edited, scene);
    scene = std::move(edited);
    return set;
}

} // namespace

Result<void> makeEdits(Scene& scene, std::span<const Edit> edits, std::string_view pointer) {
    Scene tried = scene;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        Result<void> made = makeOne(tried, edits[i]);
        if (made)
            continue;
        Error& error = made.error();
        if (!pointer.empty())
            error = within(atPointer(fmt::format("{}/{}", pointer, i)), error);
        return made;
    }
    if (Result<void> taken = takeEdited(tried, scene); !taken)
        return taken;
    scene = std::move(tried);
    return {};
}

Result<bool> makeEditsAt(Scene& scene, std::span<const Edit> edits, EditTime time) {
    Scene made = scene;
    bool keyed = false;
    for (const Edit& each : edits) {
        const Result<bool> set = makeOneAt(made, each, time);
        if (!set)
            return set;
        keyed |= *set;
    }
    if (Result<void> taken = takeEdited(made, scene); !taken)
        return fail(taken.error());
    scene = std::move(made);
    return keyed;
}

std::optional<Edit> editThat(const Scene& scene, const std::function<void(Scene&)>& change) {
    auto changed = std::make_shared<Scene>(scene);
    change(*changed);
    edit::Replace replace{changed, changedPaths(scene, *changed)};
    return replace.paths.empty() ? std::nullopt : std::optional<Edit>(std::move(replace));
}

std::optional<Edit> parseEdit(std::string_view text) {
    if (text.starts_with(presetWord) && text.size() > presetWord.size())
        return edit::ApplyPreset{std::string(text.substr(presetWord.size()))};
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        return std::nullopt;
    return edit::Set{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

std::string textOf(const Edit& edit) {
    if (const auto* set = std::get_if<edit::Set>(&edit))
        return fmt::format("{}={}", set->path, set->value);
    if (const auto* preset = std::get_if<edit::ApplyPreset>(&edit))
        return fmt::format("{}{}", presetWord, preset->name);
    return {};
}

std::string_view pathOf(const Edit& edit) {
    if (const auto* set = std::get_if<edit::Set>(&edit))
        return set->path;
    const auto* replace = std::get_if<edit::Replace>(&edit);
    return replace && replace->paths.size() == 1 ? std::string_view(replace->paths.front())
                                                 : std::string_view();
}

} // namespace texplorer
