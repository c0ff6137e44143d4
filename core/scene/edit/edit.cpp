#include "core/scene/edit/edit.h"

#include "core/scene/params/key_edits.h"
#include "core/scene/params/params.h"
#include "core/scene/params/scene_at.h"
#include "core/scene/params/scene_diff.h"
#include "core/scene/references.h"

#include <fmt/core.h>

#include <utility>

namespace texplorer {
namespace {

constexpr std::string_view presetWord = "preset:";

tl::unexpected<Error> noElement(const ListAt& list, std::string_view path, std::size_t found) {
    return fail(
        ErrorCode::OutOfRange,
        fmt::format("expected the index of one of {} elements, counted from 0, found {}", list.size(), found),
        std::string(path));
}

/// A list whose elements can be inserted, removed and moved.
Result<ListAt> variableListAt(Scene& scene, const std::string& path) {
    Result<ListAt> list = listAt(scene, path);
    if (list && !list->row->insert)
        return fail(ErrorCode::OutOfRange,
                    fmt::format("it always has {} elements, in this order", list->size()), path);
    return list;
}

Result<void> make(Scene& scene, const edit::Set& set) {
    return setParam(scene, set.path, set.value);
}

/// Copies of elements are copied from `shown`, which has the same lists.
Result<void> make(Scene& scene, const edit::Insert& insert, Scene& shown) {
    const Result<ListAt> list = variableListAt(scene, insert.list);
    if (!list)
        return fail(list.error());
    if (list->size() >= list->row->maxCount)
        return fail(ErrorCode::TooLarge, fmt::format("it already has {} elements", list->size()),
                    insert.list);
    if (insert.index > list->size())
        return noElement(*list, insert.list, insert.index);
    if (insert.copyOf && *insert.copyOf >= list->size())
        return noElement(*list, insert.list, *insert.copyOf);
    const Result<ListAt> copied = variableListAt(shown, insert.list);
    list->row->insert(list->owner, insert.index,
                      insert.copyOf && copied ? copied->row->at(copied->owner, *insert.copyOf) : nullptr);
    renumber(scene, insert.list, afterInsert(insert.index));
    return {};
}

Result<void> make(Scene& scene, const edit::Insert& insert) {
    return make(scene, insert, scene);
}

Result<void> make(Scene& scene, const edit::Remove& remove) {
    const Result<ListAt> list = variableListAt(scene, remove.list);
    if (!list)
        return fail(list.error());
    if (remove.index >= list->size())
        return noElement(*list, remove.list, remove.index);
    if (list->size() <= list->row->minCount)
        return fail(ErrorCode::TooLarge, fmt::format("it needs {} elements", list->row->minCount),
                    remove.list);
    list->row->erase(list->owner, remove.index);
    renumber(scene, remove.list, afterRemove(remove.index));
    return {};
}

Result<void> make(Scene& scene, const edit::Move& move) {
    const Result<ListAt> list = variableListAt(scene, move.list);
    if (!list)
        return fail(list.error());
    for (const std::size_t index : {move.from, move.to}) {
        if (index >= list->size())
            return noElement(*list, move.list, index);
    }
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

Result<void> make(Scene& scene, const edit::Replace& replace) {
    if (!replace.path.empty())
        return takeOver(scene, *replace.from, replace.path);
    scene = *replace.from;
    return {};
}

/// Whether it may set parameters that have key frames.
bool setsValues(const Edit& edit) {
    const auto* replace = std::get_if<edit::Replace>(&edit);
    return std::holds_alternative<edit::Set>(edit) || std::holds_alternative<edit::ApplyPreset>(edit) ||
           (replace && !replace->path.empty());
}

Result<void> makeOne(Scene& scene, const Edit& edit) {
    return std::visit([&](const auto& each) { return make(scene, each); }, edit);
}

} // namespace

Result<void> makeEdits(Scene& scene, std::span<const Edit> edits, std::string_view place) {
    Scene tried = scene;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        Result<void> made = makeOne(tried, edits[i]);
        if (made)
            continue;
        Error& error = made.error();
        if (!place.empty())
            error.where = fmt::format("{}/{}{}{}", place, i, error.where.empty() ? "" : ": ", error.where);
        return made;
    }
    scene = std::move(tried);
    return {};
}

Result<bool> makeEditsAt(Scene& scene, std::span<const Edit> edits, EditTime time) {
    Scene made = scene;
    bool keyed = false;
    for (const Edit& each : edits) {
        const bool hasKeys = !made.timeline.keys.empty();
        const auto* insert = std::get_if<edit::Insert>(&each);
        const bool copiesShown = hasKeys && insert && insert->copyOf;
        if (!copiesShown && !(hasKeys && setsValues(each))) {
            if (Result<void> done = makeOne(made, each); !done)
                return fail(done.error());
            continue;
        }
        Scene shown = sceneAt(made, time.shown);
        if (copiesShown) {
            if (Result<void> done = make(made, *insert, shown); !done)
                return fail(done.error());
            continue;
        }
        shown.timeline = made.timeline;
        Scene edited = shown;
        if (Result<void> done = makeOne(edited, each); !done)
            return fail(done.error());
        const Result<bool> set = keyEdits(edited, shown, time.key);
        if (!set)
            return fail(set.error().code,
                        fmt::format("a key frame can't be added: {}", describe(set.error())));
        putUnkeyed(edited, made);
        made = std::move(edited);
        keyed |= *set;
    }
    scene = std::move(made);
    return keyed;
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
    return replace ? std::string_view(replace->path) : std::string_view();
}

} // namespace texplorer
