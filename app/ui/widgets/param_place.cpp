#include "app/ui/widgets/param_place.h"

#include "app/ui/model/tex_coord_edits.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/tex_coords.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

namespace texplorer::ui {
namespace {

/// The number in the brackets of "textures[3]".
std::optional<std::size_t> placeIndexOf(std::string_view part) {
    const std::size_t bracket = part.find('[');
    if (bracket == std::string_view::npos || !part.ends_with(']'))
        return std::nullopt;
    std::size_t index = 0;
    const char* end = part.data() + part.size() - 1;
    const auto [stop, error] = std::from_chars(part.data() + bracket + 1, end, index);
    return error == std::errc() && stop == end ? std::optional(index) : std::nullopt;
}

/// The unit of a coordinates row of a model.
int placeUnitOf(const ParamRow& row) {
    return row.key.back() - '0';
}

/// The numbers of a Float, a vector or a matrix; empty for other values.
std::span<float> numbersOf(Value& value) {
    if (auto* one = std::get_if<float>(&value))
        return {one, 1};
    if (auto* three = std::get_if<glm::vec3>(&value))
        return {&three->x, 3};
    if (auto* four = std::get_if<glm::vec4>(&value))
        return {&four->x, 4};
    if (auto* matrix = std::get_if<glm::mat4>(&value))
        return {&(*matrix)[0].x, 16};
    return {};
}

/// The number of a component, or the nearest there is; nullptr: there are none.
float* numberOf(Value& value, int component) {
    const std::span<float> numbers = numbersOf(value);
    const auto last = static_cast<int>(numbers.size()) - 1;
    return numbers.empty() ? nullptr : &numbers[static_cast<std::size_t>(std::clamp(component, 0, last))];
}

/// The list of a vertex's row; of coordinates those that a unit takes from the mesh where it has none.
Value listOf(const ParamPlace& place) {
    if (place.row->member != memberId<&Model::texCoords>)
        return place.row->read(place.owner.values);
    const Model& model = *static_cast<const Model*>(place.owner.values);
    return effectiveTexCoords(model, meshOf(model), placeUnitOf(*place.row));
}

/// The number of a component of a vertex; nullptr: there is no such vertex.
float* numberOf(Value& list, std::size_t vertex, int component) {
    if (auto* points = std::get_if<SharedList<glm::vec3>>(&list))
        return vertex < points->size() && component >= 0 && component < 3 ? &points->edit()[vertex][component]
                                                                          : nullptr;
    if (auto* rows = std::get_if<SharedList<glm::vec4>>(&list))
        return vertex < rows->size() && component >= 0 && component < 4 ? &rows->edit()[vertex][component]
                                                                        : nullptr;
    return nullptr;
}

std::string elementText(const Value& list, std::size_t vertex) {
    if (const auto* points = std::get_if<SharedList<glm::vec3>>(&list))
        return formatNumbers({&(*points)[vertex].x, 3});
    return formatNumbers({&std::get<SharedList<glm::vec4>>(list)[vertex].x, 4});
}

/// The name of the step of undo.
Sentence nameOfChange(const ParamPlace& place) {
    if (place.row->kind == Kind::TexCoordList || place.row->member == memberId<&MeshData::positions>)
        return Sentence("Move vertex {0}", *place.vertex);
    const Sentence label = std::string(place.row->label);
    return place.vertices > 1 ? Sentence("{0}: vertices {1} to {2}", label, *place.vertex,
                                         *place.vertex + place.vertices - 1)
                              : Sentence("{0}: vertex {1}", label, *place.vertex);
}

void assignElement(const Session& session, const ParamPlace& place, int component, float number) {
    Value list = listOf(place);
    const float* now = numberOf(list, *place.vertex, component);
    if (!now || *now == number)
        return;
    const std::string path = place.owner.pathOf(*place.row);
    std::vector<Edit> edits;
    for (std::size_t i = *place.vertex; i < *place.vertex + place.vertices; ++i) {
        if (float* changed = numberOf(list, i, component)) {
            *changed = number;
            edits.push_back(edit::Set{fmt::format("{}[{}]", path, i), elementText(list, i)});
        }
    }
    submit(session, {.name = nameOfChange(place),
                     .edits = std::move(edits),
                     .path = fmt::format("{}[{}]", path, *place.vertex),
                     .continues = true});
}

} // namespace

std::optional<ParamPlace> placeOf(const Scene& scene, std::string_view path) {
    const StructTable* table = &sceneTable();
    void* values = const_cast<Scene*>(
        &scene); // the tables' functions take a pointer they may write to; here it is only read
    ParamPlace place{{nullptr, nullptr, {}}};
    while (true) {
        const std::size_t dot = path.find('.');
        const std::string_view part = path.substr(0, dot);
        const std::string_view key = part.substr(0, part.find('['));
        const std::optional<std::size_t> index = placeIndexOf(part);
        if (const ParamRow* row = findParam(*table, key)) {
            if (dot != std::string_view::npos || (index && !hasElements(*row)))
                return std::nullopt;
            place.owner.values = values;
            place.row = row;
            place.vertex = index;
            return place;
        }
        const ChildRow* child = findChild(*table, key);
        if (!child || dot == std::string_view::npos || child->indexed != index.has_value() ||
            index.value_or(0) >= child->size(values))
            return std::nullopt;
        values = child->at(values, index.value_or(0));
        place.owner.path += fmt::format("{}{}", place.owner.path.empty() ? "" : ".", part);
        table = child->table;
        path.remove_prefix(dot + 1);
    }
}

float numberAt(const ParamPlace& place, int component) {
    if (place.vertex) {
        Value list = listOf(place);
        const float* number = numberOf(list, *place.vertex, component);
        return number ? *number : 0.0F;
    }
    Value value = place.row->read(place.owner.values);
    if (const int* whole = std::get_if<int>(&value))
        return static_cast<float>(*whole);
    const float* number = numberOf(value, component);
    return number ? *number : 0.0F;
}

std::size_t sharedFrom(const ParamPlace& place) {
    if (!place.vertex || place.row->member != memberId<&MeshData::normals>)
        return 1;
    const auto normals = std::get<SharedList<glm::vec3>>(place.row->read(place.owner.values));
    std::size_t end = *place.vertex;
    while (end < normals.size() && normals[end] == normals[*place.vertex])
        ++end;
    return end - *place.vertex;
}

void assignNumber(const Session& session, const ParamPlace& place, int component, float number) {
    const Range range = rangeOf(place);
    number = std::clamp(number, range.min, range.max);
    if (place.vertex)
        return assignElement(session, place, component, number);
    Value value = place.row->read(place.owner.values);
    if (int* whole = std::get_if<int>(&value))
        *whole = static_cast<int>(std::lround(number));
    else if (float* changed = numberOf(value, component))
        *changed = number;
    assignParam(session, place.owner, *place.row, value);
}

Range rangeOf(const ParamPlace& place) {
    constexpr Range pointRange{-1e6F, 1e6F, 0.005F, {}};
    if (place.vertex && place.row->kind == Kind::PointList)
        return pointRange;
    return place.vertex && place.row->kind == Kind::TexCoordList ? coordRange : place.row->range;
}

} // namespace texplorer::ui
