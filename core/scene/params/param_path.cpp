// Parameters by their path: "passes[0].units[1].envMode".

#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_check.h"
#include "texplorer/scene/params/timeline_check.h"
#include "texplorer/scene/params/value_mix.h"
#include "texplorer/text/nearest_name.h"

#include <fmt/core.h>

#include <charconv>
#include <deque>
#include <optional>

namespace texplorer {
namespace {

/// Where a path leads: a row of the struct at `owner`, and for a list perhaps one vertex of it.
struct Place {
    const StructTable* table = nullptr;
    void* owner = nullptr;
    const ParamRow* row = nullptr;
    std::optional<std::size_t> vertex;
};

/// One part of a path, "textures[0]": its key and, where it has one, the text between the brackets.
struct Part {
    std::string_view whole;
    std::string_view key;
    std::optional<std::string_view> index;
};

std::string lowerFirst(std::string_view name) {
    std::string text(name);
    text.front() = static_cast<char>(text.front() - 'A' + 'a');
    return text;
}

std::optional<std::size_t> parseIndex(std::string_view text) {
    std::size_t index = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, index);
    if (error == std::errc::result_out_of_range && stop == end)
        return static_cast<std::size_t>(-1); // beyond any list, which the comparison says
    if (error != std::errc() || stop != end || text.empty())
        return std::nullopt;
    return index;
}

/// The first path from a table down to a parameter of this name, breadth first: "textures[0].minFilter";
/// empty: there is none.
std::string pathBelow(const StructTable& table, std::string_view key) {
    struct Below {
        const StructTable* table;
        std::string path;
        int depth;
    };
    constexpr int maxDepth = 4; // of a table that has itself below it there is no end
    std::deque<Below> waiting{{&table, {}, 0}};
    for (; !waiting.empty(); waiting.pop_front()) {
        const Below at = waiting.front();
        if (findParam(*at.table, key) != nullptr)
            return at.path + std::string(key);
        if (at.depth == maxDepth)
            continue;
        for (const ChildRow& child : at.table->children)
            waiting.push_back({child.table,
                               fmt::format("{}{}{}.", at.path, child.key, child.indexed ? "[0]" : ""),
                               at.depth + 1});
    }
    return {};
}

/// Calls visit(list) with the list that a value is.
template<class ListValue, class Visit>
void visitList(ListValue& value, const Visit& visit) {
    std::visit(
        [&]<class Each>(Each& each) {
            if constexpr (requires { each.front(); } &&
                          !std::is_same_v<std::remove_const_t<Each>, std::string>)
                visit(each);
        },
        value);
}

std::size_t sizeOf(const Value& list) {
    std::size_t size = 0;
    visitList(list, [&](const auto& each) { size = each.size(); });
    return size;
}

/// The list with one of its elements alone.
Value elementAlone(Value list, std::size_t index) {
    visitList(list, [&]<class List>(List& each) { each = List(1, each[index]); });
    return list;
}

class Walker {
public:
    Walker(Scene& scene, std::string_view path)
        : rest_(path) {
        place_.table = &sceneTable();
        place_.owner = &scene;
    }

    Result<Place> walk() {
        while (!place_.row) {
            if (Result<void> entered = enter(next()); !entered)
                return fail(std::move(entered.error()));
        }
        return place_;
    }

    Result<ListAt> walkToList() {
        while (!place_.row) {
            const Part part = next();
            const ChildRow* child = findChild(*place_.table, part.key);
            if (child && child->indexed && !part.index && !dotted_)
                return ListAt{child, place_.owner};
            if (Result<void> entered = enter(part); !entered)
                return fail(std::move(entered.error()));
        }
        return refuse("it is no list");
    }

private:
    Result<void> enter(const Part& part) {
        const ParamRow* row = findParam(*place_.table, part.key);
        const ChildRow* child = findChild(*place_.table, part.key);
        walked_.append(walked_.empty() ? "" : ".").append(shortened(part.whole));
        if (!row && !child)
            return refuse(Sentence("no such parameter; {0}", suggested(part.key)));
        return row ? enter(*row, part) : enter(*child, part);
    }

    Part next() {
        const std::size_t dot = rest_.find('.');
        Part part{rest_.substr(0, dot), rest_.substr(0, dot), {}};
        rest_ = dot == std::string_view::npos ? std::string_view() : rest_.substr(dot + 1);
        dotted_ = dot != std::string_view::npos;
        const std::size_t bracket = part.whole.find('[');
        if (bracket != std::string_view::npos && part.whole.ends_with(']')) {
            part.key = part.whole.substr(0, bracket);
            part.index = part.whole.substr(bracket + 1, part.whole.size() - bracket - 2);
        }
        return part;
    }

    /// Where there is no such key: one that is close, or a parameter below it that has that name.
    Sentence suggested(std::string_view key) const {
        const std::vector<std::string_view> keys = tableKeys(*place_.table);
        if (!dotted_ && nearestName(key, keys).empty()) {
            const std::string below = pathBelow(*place_.table, key);
            if (!below.empty()) {
                const std::size_t dot = walked_.rfind('.');
                const std::string before = dot == std::string::npos ? "" : walked_.substr(0, dot + 1);
                return Sentence("did you mean {0}?", ProperName{before + below});
            }
        }
        return suggestName(key, keys);
    }

    Result<void> enter(const ParamRow& row, const Part& part) {
        if (dotted_)
            return refuse("it is a value without parts: expected the path to end here");
        place_.row = &row;
        if (!part.index)
            return {};
        if (!hasElements(row))
            return refuse(isList(row.kind) ? "it is set as a whole: expected no index"
                                           : N_("it is a single value: expected no index"));
        place_.vertex = parseIndex(*part.index);
        if (!place_.vertex)
            return refuse(Sentence("expected the number of a vertex in the brackets, found {0}",
                                   inQuotes(*part.index)));
        return row.member == memberId<&Model::texCoords>
                   ? checkVertex(*static_cast<const Model*>(place_.owner))
                   : checkElement(row);
    }

    [[nodiscard]] Result<void> checkElement(const ParamRow& row) const {
        const std::size_t count = sizeOf(row.read(place_.owner));
        if (*place_.vertex >= count)
            return refuse(Sentence("expected an existing index, counted from 0; the list has {0}", count));
        return {};
    }

    [[nodiscard]] Result<void> checkVertex(const Model& model) const {
        const std::size_t count = vertexCountOf(model);
        if (*place_.vertex >= count)
            return refuse(count == 0 ? "the mesh has no vertices"
                                     : Sentence("the {0} has {1} vertices, expected 0 to {2}",
                                                rowOf(model.shape).name, count, count - 1));
        return {};
    }

    Result<void> enter(const ChildRow& child, const Part& part) {
        if (child.indexed != part.index.has_value())
            return refuse(child.indexed ? Sentence("an index is needed, as in {0}[0]; {1}",
                                                   ProperName{child.key}, has(child))
                                        : "it is not a list: expected no index");
        std::size_t index = 0;
        if (part.index) {
            const auto parsed = parseIndex(*part.index);
            if (!parsed)
                return refuse(
                    Sentence("expected a number in the brackets, found {0}", inQuotes(*part.index)));
            if (*parsed >= child.size(place_.owner))
                return refuse(Sentence("expected an existing index, counted from 0; {0}", has(child)));
            index = *parsed;
        }
        place_.owner = child.at(place_.owner, index);
        place_.table = child.table;
        if (!dotted_)
            return refuse(
                Sentence("it has parameters of its own; {0}", suggestName("", tableKeys(*child.table))));
        return {};
    }

    /// "the scene has 1"
    Sentence has(const ChildRow& child) const {
        return Sentence("the {0} has {1}", lowerFirst(place_.table->name), child.size(place_.owner));
    }

    tl::unexpected<Error> refuse(Sentence message) const {
        return fail(ErrorCode::OutOfRange, std::move(message), walked_);
    }

    Place place_;
    std::string_view rest_;
    std::string walked_;
    bool dotted_ = false;
};

/// The list of coordinates at a place, taken from the mesh where the scene has none that fits.
TexCoords filledTexCoords(const Place& place) {
    const Model& model = *static_cast<const Model*>(place.owner);
    TexCoords list = std::get<SharedList<glm::vec4>>(place.row->read(place.owner));
    if (!list.empty() && checkVertexList(model, *place.row))
        return list;
    const Mesh mesh = meshOf(model);
    list.resize(mesh.vertices.size());
    std::ranges::transform(mesh.vertices, list.begin(), &Vertex::texCoord);
    return list;
}

/// Positions may be set first, with any other lists: those have no effect until they fit.
Result<void> checkMesh(const MeshData& mesh, const ParamRow& row) {
    return row.member == memberId<&MeshData::positions> ? Result<void>() : checkMeshList(mesh, row);
}

Result<void> checkInScene(const Scene& scene, const Place& place) {
    if (place.table == &modelTable() && isList(place.row->kind))
        return checkVertexList(*static_cast<const Model*>(place.owner), *place.row);
    if (place.row->member == memberId<&Pass::models>)
        return checkPassModels(scene, *static_cast<const Pass*>(place.owner));
    if (place.table == &meshTable() && isList(place.row->kind))
        return checkMesh(*static_cast<const MeshData*>(place.owner), *place.row);
    if (place.table == &unitTable())
        return checkUnitTexture(scene, *static_cast<const Unit*>(place.owner));
    if (place.table == &keyFrameTable())
        return checkEditedKey(scene, *static_cast<const KeyFrame*>(place.owner), *place.row);
    return {};
}

/// A list of one element.
Result<Value> parseElement(const ParamRow& row, std::string_view text) {
    Result<Value> parsed = parseValue(row, text);
    if (const std::size_t count = parsed ? sizeOf(*parsed) : 1; count != 1)
        return fail(ErrorCode::OutOfRange, Sentence("expected the value of one element, found {0}", count));
    return parsed;
}

/// What a text says there: of a single vertex the whole list, with that one changed.
Result<Value> valueOf(const Place& place, std::string_view text) {
    if (!place.vertex)
        return parseValue(*place.row, text);
    if (place.row->member == memberId<&Model::texCoords>) {
        const auto coord = parseTexCoord(text);
        if (!coord)
            return fail(coord.error());
        TexCoords list = filledTexCoords(place);
        list[*place.vertex] = *coord;
        return list;
    }
    const Result<Value> element = parseElement(*place.row, text);
    if (!element)
        return fail(element.error());
    Value list = place.row->read(place.owner);
    visitList(list,
              [&]<class List>(List& each) { each.edit()[*place.vertex] = std::get<List>(*element).front(); });
    return list;
}

Error timelineMoved() {
    return {ErrorCode::OutOfRange, N_("a key can't move the timeline itself"), {}};
}

Error fileMoved() {
    return {ErrorCode::OutOfRange, N_("key frames can't change what a mesh has from a file"), {}};
}

/// The name of a file of vertices, or something of the vertices.
bool isOfMeshFile(const Place& place) {
    if (place.row->member == memberId<&MeshData::file> || place.row->member == memberId<&MeshData::part>)
        return true;
    const MeshData* mesh = place.table == &meshTable()    ? static_cast<const MeshData*>(place.owner)
                           : place.table == &modelTable() ? &static_cast<const Model*>(place.owner)->mesh
                                                          : nullptr;
    return mesh && isList(place.row->kind) && !mesh->file.empty();
}

void visitStruct(const StructTable& table, void* owner, const std::string& prefix,
                 const std::function<void(const std::string&, const ParamRow&, const Value&)>& visit) {
    for (const ParamRow& row : table.params)
        visit(prefix + std::string(row.key), row, row.read(owner));
    for (const ChildRow& child : table.children)
        for (std::size_t i = 0; i < child.size(owner); ++i) {
            std::string path = prefix + std::string(child.key);
            if (child.indexed)
                path += fmt::format("[{}]", i);
            visitStruct(*child.table, child.at(owner, i), path + ".", visit);
        }
}

} // namespace

bool hasElements(const ParamRow& row) {
    return row.member == memberId<&Model::texCoords> ||
           (isList(row.kind) && findParam(meshTable(), row.key) == &row);
}

void forEachParam(
    const Scene& scene,
    const std::function<void(const std::string& path, const ParamRow& row, const Value& value)>& visit) {
    // The tables reach members through void*; nothing is written on this way.
    visitStruct(sceneTable(), const_cast<Scene*>(&scene), "", visit);
}

Result<ParamAt> paramAt(const Scene& scene, std::string_view path) {
    const auto place = Walker(const_cast<Scene&>(scene), path).walk(); // only read below
    if (!place)
        return fail(place.error());
    return ParamAt{place->row, place->row->read(place->owner)};
}

Result<const ParamRow*> rowAt(const Scene& scene, std::string_view path) {
    const auto place = Walker(const_cast<Scene&>(scene), path).walk(); // nothing is written
    if (!place)
        return fail(place.error());
    return place->row;
}

Result<ListAt> listAt(Scene& scene, std::string_view path) {
    return Walker(scene, path).walkToList();
}

Result<std::string> getParam(const Scene& scene, std::string_view path) {
    const auto place = Walker(const_cast<Scene&>(scene), path).walk(); // only read below
    if (!place)
        return fail(place.error());
    if (place->vertex && place->row->member == memberId<&Model::texCoords>)
        return formatTexCoord(filledTexCoords(*place)[*place->vertex]);
    const Value value = place->row->read(place->owner);
    return formatValue(*place->row, place->vertex ? elementAlone(value, *place->vertex) : value);
}

namespace {

/// "textures[0].preparation[+].op": in a new last element of the list.
Result<void> setInNewElement(Scene& scene, std::string_view path, std::size_t index, std::string_view text) {
    const std::string_view listPath = path.substr(0, index);
    Scene tried = scene; // if the value does not fit, there is no new element
    const Result<ListAt> list = listAt(tried, listPath);
    if (!list)
        return fail(list.error());
    const std::size_t count = list->size();
    if (!list->row->insert || count >= list->row->maxCount)
        return fail(ErrorCode::TooLarge, Sentence("it already has {0} elements", count),
                    std::string(listPath));
    list->row->insert(list->owner, count, nullptr);
    Result<void> done = setParam(
        tried, fmt::format("{}[{}]{}", listPath, count, path.substr(index + newElement.size())), text);
    if (done)
        scene = std::move(tried);
    return done;
}

} // namespace

Result<void> setParam(Scene& scene, std::string_view path, std::string_view text) {
    if (const std::size_t index = path.find(newElement); index != std::string_view::npos)
        return setInNewElement(scene, path, index, text);
    const auto place = Walker(scene, path).walk();
    if (!place)
        return fail(place.error());

    const auto refuse = [&](Error error) {
        return fail(error.code, std::move(error.message), std::string(path));
    };
    const auto value = valueOf(*place, text);
    if (!value)
        return refuse(value.error());

    const Value before = place->row->read(place->owner);
    place->row->write(place->owner, *value);
    if (auto checked = checkInScene(scene, *place); !checked) {
        place->row->write(place->owner, before);
        return refuse(std::move(checked.error()));
    }
    return {};
}

Result<void> putBetween(Scene& scene, std::string_view path, std::string_view from, std::string_view to,
                        double share) {
    const auto place = Walker(scene, path).walk();
    if (!place)
        return fail(place.error());
    const auto refuse = [&](Error error) {
        return fail(error.code, std::move(error.message), std::string(path));
    };
    if (place->table == &keyFrameTable())
        return refuse(timelineMoved());
    if (isOfMeshFile(*place))
        return refuse(fileMoved());
    const auto first = valueOf(*place, from);
    if (!first)
        return refuse(first.error());
    if (share <= 0 || !canMix(*place->row)) {
        place->row->write(place->owner, *first);
        return {};
    }
    const auto second = valueOf(*place, to);
    if (!second)
        return refuse(second.error());
    place->row->write(place->owner, mixed(*place->row, *first, *second, share));
    return {};
}

Result<void> checkMovable(const Scene& scene, std::string_view path, std::string_view text) {
    const auto place = Walker(const_cast<Scene&>(scene), path).walk(); // nothing is written
    if (!place)
        return fail(place.error());
    const auto refuse = [&](Error error) {
        return fail(error.code, std::move(error.message), std::string(path));
    };
    if (place->table == &keyFrameTable())
        return refuse(timelineMoved());
    if (isOfMeshFile(*place))
        return refuse(fileMoved());
    if (place->row->kind == Kind::IndexList) { // numbers of others, which must exist
        Scene edited = scene;
        return setParam(edited, path, text);
    }
    if (place->vertex && place->row->member == memberId<&Model::texCoords>) {
        const auto coord = parseTexCoord(text);
        return coord ? Result<void>() : refuse(coord.error());
    }
    const auto value = place->vertex ? parseElement(*place->row, text) : parseValue(*place->row, text);
    return value ? Result<void>() : refuse(value.error());
}

} // namespace texplorer
