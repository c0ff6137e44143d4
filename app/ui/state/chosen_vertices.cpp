#include "app/ui/state/chosen_vertices.h"

#include <algorithm>
#include <optional>

namespace texplorer::ui {
namespace {

bool groupCounts(const Selection& selection) {
    return selection.vertex && selection.group.model == selection.model &&
           std::ranges::binary_search(selection.group.vertices, *selection.vertex);
}

} // namespace

std::vector<std::size_t> chosenVertices(const Selection& selection) {
    if (groupCounts(selection))
        return selection.group.vertices;
    return selection.vertex ? std::vector{*selection.vertex} : std::vector<std::size_t>{};
}

bool isChosen(const Selection& selection, std::size_t vertex) {
    if (selection.vertex == vertex)
        return true;
    return groupCounts(selection) && std::ranges::binary_search(selection.group.vertices, vertex);
}

void chooseVertices(Selection& selection, std::vector<std::size_t> vertices) {
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const bool stays = selection.vertex && std::ranges::binary_search(vertices, *selection.vertex);
    if (!stays)
        selection.vertex = vertices.empty() ? std::nullopt : std::optional(vertices.front());
    selection.group = {selection.model, std::move(vertices)};
}

void toggleVertex(Selection& selection, std::size_t vertex) {
    std::vector<std::size_t> vertices = chosenVertices(selection);
    if (std::erase(vertices, vertex) == 0) {
        vertices.push_back(vertex);
        selection.vertex = vertex;
    }
    chooseVertices(selection, std::move(vertices));
}

} // namespace texplorer::ui
