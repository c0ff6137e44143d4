#include "texplorer/scene/params/scene_schema.h"

#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_json.h"
#include "texplorer/scene/params/param_text.h"

#include <limits>
#include <map>

namespace texplorer {
namespace {

/// What a student reads, and the call that it is in OpenGL.
std::string descriptionOf(const ParamRow& row) {
    std::string text(row.help);
    if (!row.range.unit.empty())
        text += fmt::format(" Unit: {}.", row.range.unit);
    if (!row.range.initially.empty())
        text += fmt::format(" Initially: {}.", row.range.initially);
    if (const std::string call = callFor(row, Unit().target); !call.empty())
        text += "\n" + call;
    return text;
}

OrderedJson numberWithin(float min, float max) {
    return {{"type", "number"}, {"minimum", min}, {"maximum", max}};
}

OrderedJson wholeNumberWithin(const Range& range) {
    return {{"type", "integer"},
            {"minimum", static_cast<std::int64_t>(range.min)},
            {"maximum", static_cast<std::int64_t>(range.max)}};
}

OrderedJson arrayOf(OrderedJson items, std::size_t min, std::size_t max) {
    return {{"type", "array"}, {"items", std::move(items)}, {"minItems", min}, {"maxItems", max}};
}

/// Names, and for those of numbers also the number itself, which the reader accepts, too.
OrderedJson choicesOf(std::span<const EnumRow> choices) {
    OrderedJson names = OrderedJson::array();
    OrderedJson help = OrderedJson::array();
    for (const EnumRow& choice : choices) {
        names.push_back(choice.name);
        help.push_back(choice.help);
        if (choice.name.find_first_not_of("0123456789") == std::string_view::npos) {
            names.push_back(std::stoi(std::string(choice.name)));
            help.push_back(choice.help);
        }
    }
    return {{"enum", std::move(names)}, {"enumDescriptions", std::move(help)}}; // editors show the latter
}

/// A key frame's value: what it spells may stand without quotes.
OrderedJson keyValue() {
    const OrderedJson numbers{{"type", "array"}, {"items", {{"type", "number"}}}, {"maxItems", 16}};
    return {{"anyOf",
             {{{"type", "string"}, {"maxLength", maxTextBytes}, {"pattern", "^[^\\u0000]*$"}},
              {{"type", "number"}},
              {{"type", "boolean"}},
              numbers}}};
}

OrderedJson elementsOf(const ParamRow& row) {
    constexpr float max = std::numeric_limits<float>::max();
    const ElementNumbers numbers = *elementNumbers(row.kind);
    const bool limited = row.kind == Kind::ColorList;
    return arrayOf(arrayOf(limited ? numberWithin(row.range.min, row.range.max)
                                   : numberWithin(std::numeric_limits<float>::lowest(), max),
                           numbers.min, numbers.max),
                   0, row.maxCount);
}

/// What the reader accepts for a row.
OrderedJson acceptedBy(const ParamRow& row) {
    if (row.member == memberId<&KeyFrame::value>)
        return keyValue();
    const OrderedJson number = numberWithin(row.range.min, row.range.max);
    switch (row.kind) {
    case Kind::Bool:
        return {{"type", "boolean"}};
    case Kind::Int:
        return wholeNumberWithin(row.range);
    case Kind::Float:
        return number;
    case Kind::Vec3:
        return arrayOf(number, 3, 3);
    case Kind::Vec4:
    case Kind::Color:
        return arrayOf(number, 4, 4);
    case Kind::Matrix:
        return arrayOf(number, 16, 16);
    case Kind::Enum:
        return choicesOf(row.choices);
    case Kind::Text: // whose letters take a byte or more
        return {{"type", "string"}, {"maxLength", maxTextBytes}, {"pattern", "^[^\\u0000]*$"}};
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
        return elementsOf(row);
    case Kind::IndexList: {
        const bool names = row.member == memberId<&Pass::models>; // models, at least one
        OrderedJson list = arrayOf(wholeNumberWithin(row.range), names ? 1 : 0, row.maxCount);
        if (row.member != memberId<&MeshData::indices>) // each once
            list["uniqueItems"] = true;
        return list;
    }
    }
    return {};
}

class Schema {
public:
    OrderedJson make() {
        Scene start = defaultScene(); // what a file leaves out keeps its value
        OrderedJson root = structOf(sceneTable(), &start);
        OrderedJson properties{
            {schemaKey, {{"type", "string"}, {"description", N_("This schema, for the editor.")}}},
            {versionKey,
             {{"type", "integer"},
              {"minimum", 1},
              {"maximum", sceneFormatVersion},
              {"description", N_("The version of the format.")},
              {"default", sceneFormatVersion}}}};
        properties.update(root["properties"]);
        return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"$id", sceneSchemaId},
                {"title", N_("Texplorer scene")},
                {"description", N_("A scene of Texplorer. Missing keys have their initial values.")},
                {"type", "object"},
                {"properties", std::move(properties)},
                {"additionalProperties", false},
                {"$defs", std::move(structs_)}};
    }

private:
    /// `owner` has the initial values.
    OrderedJson structOf(const StructTable& table, void* owner) {
        OrderedJson properties = OrderedJson::object();
        for (const ParamRow& row : table.params) {
            OrderedJson param{{"title", row.label}, {"description", descriptionOf(row)}};
            param.update(acceptedBy(row));
            if (!isList(row.kind))
                param["default"] = jsonValue(row, row.read(owner));
            properties[std::string(row.key)] = std::move(param);
        }
        for (const ChildRow& child : table.children)
            properties[std::string(child.key)] = memberOf(table, child, owner);
        return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
    }

    OrderedJson memberOf(const StructTable& table, const ChildRow& child, void* owner) {
        if (child.minCount != child.maxCount) { // as a new element has them
            child.resize(owner, 0);
            child.resize(owner, 1);
        }
        OrderedJson reference{{"$ref", "#/$defs/" + definition(table, child, child.at(owner, 0))}};
        OrderedJson member{{"title", child.label}};
        if (!child.indexed) {
            member.update(reference);
            return member;
        }
        const bool isFixed = child.minCount == child.maxCount; // of which a file may leave out the end
        member.update(arrayOf(std::move(reference), isFixed ? 0 : child.minCount, child.maxCount));
        return member;
    }

    /// The name under which a struct is defined. Two tables may have the same name.
    std::string definition(const StructTable& owner, const ChildRow& child, void* element) {
        if (const auto found = names_.find(child.table); found != names_.end())
            return found->second;
        std::string name(child.table->name);
        if (structs_.contains(name))
            name.insert(0, owner.name);
        names_.emplace(child.table, name);
        structs_[name] = nullptr; // its place, before those of its members
        OrderedJson made = structOf(*child.table, element);
        structs_[name] = std::move(made);
        return name;
    }

    std::map<const StructTable*, std::string> names_;
    OrderedJson structs_ = OrderedJson::object();
};

} // namespace

std::string sceneSchema() {
    return Schema().make().dump(2) + "\n";
}

} // namespace texplorer
