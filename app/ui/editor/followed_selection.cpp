#include "app/ui/editor/followed_selection.h"

#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/references.h"

namespace texplorer::ui {
namespace {

int* selectedIn(Selection& selection, std::string_view list) {
    return list == keyOf<&Scene::models>()   ? &selection.model
           : list == keyOf<&Scene::passes>() ? &selection.pass
                                             : nullptr;
}

void renumber(int& selected, const Renumbering& number) {
    if (const std::optional<std::size_t> now = number(static_cast<std::size_t>(selected)))
        selected = static_cast<int>(*now);
}

void followOne(int& selected, const edit::Insert& insert) {
    selected = static_cast<int>(insert.index);
}

void followOne(int& selected, const edit::Remove& remove) {
    renumber(selected, afterRemove(remove.index));
}

void followOne(int& selected, const edit::Move& move) {
    renumber(selected, afterMove(move.from, move.to));
}

} // namespace

bool follow(Selection& selection, const Edit& edit) {
    return std::visit(
        [&](const auto& each) {
            if constexpr (requires { each.list; }) {
                int* const selected = selectedIn(selection, each.list);
                if (selected)
                    followOne(*selected, each);
                if (selected == &selection.model)
                    selection.vertex.reset();
                return selected != nullptr;
            } else {
                return false;
            }
        },
        edit);
}

} // namespace texplorer::ui
