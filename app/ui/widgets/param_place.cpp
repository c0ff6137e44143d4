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

bool isTexCoord(const ParamPlace& place) {
    return place.vertex && place.row->member == memberId<&Model::texCoords>;
}

/// The numbers of one vertex of a list; empty if there is no such vertex.
std::span<float> numbersOf(Value& list, std::size_t vertex) {
    if (auto* points = std::get_if<std::vector<glm::vec3>>(&list); points && vertex < points->size())
        return {&(*points)[vertex].x, 3};
    if (auto* rows = std::get_if<std::vector<glm::vec4>>(&list); rows && vertex < rows->size())
        return {&(*rows)[vertex].x, 4};
    return {};
}

/// Of a list of a mesh.
void assignElement(const Session& session, const ParamPlace& place, int component, float number) {
    Value list = place.row->read(place.owner.values);
    const std::span<float> numbers = numbersOf(list, *place.vertex);
    const auto at = static_cast<std::size_t>(std::max(component, 0));
    if (at >= numbers.size() || numbers[at] == number)
        return;
    numbers[at] = number;
    const std::string path = fmt::format("{}[{}]", place.owner.pathOf(*place.row), *place.vertex);
    const bool moves = place.row->member == memberId<&MeshData::positions>;
    submit(session, {.name = moves ? Sentence("Move vertex {0}", *place.vertex)
                                   : Sentence("{0}: vertex {1}", Sentence(std::string(place.row->label)),
                                              *place.vertex),
                     .edits = {edit::Set{path, formatNumbers(numbers)}},
                     .path = path,
                     .continues = true});
}

void assignCoord(const Session& session, const ParamPlace& place, int component, float number) {
    const Model& model = *static_cast<const Model*>(place.owner.values);
    const TexCoords coords = effectiveTexCoords(model, meshOf(model), placeUnitOf(*place.row));
    if (*place.vertex >= coords.size() || component < 0 || component > 3)
        return;
    glm::vec4 coord = coords[*place.vertex];
    if (coord[component] == number)
        return;
    coord[component] = number;
    const std::string path = fmt::format("{}[{}]", place.owner.pathOf(*place.row), *place.vertex);
    submit(session, {.name = Sentence("Move vertex {0}", *place.vertex),
                     .edits = {edit::Set{path, formatNumbers({&coord.x, 4})}},
                     .path = path,
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
            const bool isIndexed =
                isList(row->kind) && (row->kind == Kind::TexCoordList || table == &meshTable());
            if (dot != std::string_view::npos || (index && !isIndexed))
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
    if (isTexCoord(place)) {
        const Model& model = *static_cast<const Model*>(place.owner.values);
        const TexCoords coords = effectiveTexCoords(model, meshOf(model), placeUnitOf(*place.row));
        return *place.vertex < coords.size() && component >= 0 && component < 4
                   ? coords[*place.vertex][component]
                   : 0.0F;
    }
    Value value = place.row->read(place.owner.values);
    if (place.vertex) {
        const std::span<float> numbers = numbersOf(value, *place.vertex);
        const auto at = static_cast<std::size_t>(std::max(component, 0));
        return at < numbers.size() ? numbers[at] : 0.0F;
    }
    if (const int* whole = std::get_if<int>(&value))
        return static_cast<float>(*whole);
    const float* number = numberOf(value, component);
    return number ? *number : 0.0F;
}

void assignNumber(const Session& session, const ParamPlace& place, int component, float number) {
    const Range range = rangeOf(place);
    number = std::clamp(number, range.min, range.max);
    if (isTexCoord(place))
        return assignCoord(session, place, component, number);
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
