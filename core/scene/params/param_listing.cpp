#include "texplorer/scene/params/param_listing.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_json.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>

namespace texplorer {
namespace {

struct Visitor {
    std::function<void(const std::string& path, const ParamRow& row, const Value& initial)> param;
    std::function<void(const std::string& path, const ChildRow& child)> list;
};

/// Walks the tables with one element in each list, as it is when it is new.
void walk(const StructTable& table, void* owner, const std::string& prefix, const Visitor& visitor) {
    for (const ParamRow& row : table.params)
        visitor.param(prefix + std::string(row.key), row, row.read(owner));
    for (const ChildRow& child : table.children) {
        std::string path = prefix + std::string(child.key);
        if (child.indexed) {
            path += "[]";
            visitor.list(path, child);
        }
        if (child.minCount != child.maxCount) {
            child.resize(owner, 0);
            child.resize(owner, 1);
        }
        walk(*child.table, child.at(owner, 0), path + ".", visitor);
    }
}

/// Those that are listed, and the lists that they lie in, each before what lies in it.
void walkAll(const Visitor& visitor, const ParamFilter& filter) {
    Scene start = defaultScene();                              // what a scene that says nothing begins with
    std::vector<std::pair<std::string, const ChildRow*>> open; // lists of which nothing was listed yet
    const auto param = [&](const std::string& path, const ParamRow& row, const Value& initial) {
        if (filter && !filter(path, row))
            return;
        for (const auto& [list, child] : open)
            if (path.starts_with(list + "."))
                visitor.list(list, *child);
        std::erase_if(open, [&](const auto& each) { return path.starts_with(each.first + "."); });
        visitor.param(path, row, initial);
    };
    const auto list = [&](const std::string& path, const ChildRow& child) {
        open.emplace_back(path, &child);
    };
    walk(sceneTable(), &start, "", {param, list});
}

std::string_view kindName(Kind kind) {
    switch (kind) {
    case Kind::Bool:
        return "bool";
    case Kind::Int:
        return "int";
    case Kind::Float:
        return "float";
    case Kind::Vec3:
        return "vec3";
    case Kind::Vec4:
        return "vec4";
    case Kind::Color:
        return "color";
    case Kind::Enum:
        return "enum";
    case Kind::Text:
        return "text";
    case Kind::Matrix:
        return "matrix";
    case Kind::PointList:
        return "points";
    case Kind::ColorList:
        return "colors";
    case Kind::TexCoordList:
        return "texCoords";
    case Kind::IndexList:
        return "indices";
    }
    return {};
}

bool hasRange(Kind kind) {
    return kind == Kind::Int || kind == Kind::Float || kind == Kind::Vec3 || kind == Kind::Vec4 ||
           kind == Kind::Color || kind == Kind::Matrix || kind == Kind::ColorList || kind == Kind::IndexList;
}

/// Breaks a text between words into lines of at most 100 columns, each with this indent.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t firstIndent) {
    constexpr std::size_t width = 100;
    std::string out(firstIndent, ' ');
    std::size_t column = indent;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        if (column > indent && column + 1 + word.size() > width) {
            out.append("\n").append(indent, ' ');
            column = indent;
        } else if (column > indent) {
            out += ' ';
            ++column;
        }
        out += word;
        column += word.size();
    }
    return out + "\n";
}

} // namespace

void forEachNewParam(
    const std::function<void(const std::string& path, const ParamRow& row, const Value& initial)>& visit) {
    walkAll({visit, [](const std::string& /*path*/, const ChildRow& /*child*/) {}}, {});
}

std::string listParams(const ParamFilter& filter) {
    std::string out;
    const auto list = [&](const std::string& path, const ChildRow& child) {
        out += path + "   ";
        if (child.minCount == child.maxCount)
            out += fmt::format("always {} of them", child.maxCount);
        else
            out += fmt::format("{} to {} of them", child.minCount, child.maxCount);
        out += ", counted from 0\n\n";
    };
    const auto param = [&](const std::string& path, const ParamRow& row, const Value& initial) {
        out += path;
        if (const std::string text = formatValue(row, initial); !text.empty())
            out += " = " + text;
        out += "\n" + wrapped(row.help, 4, 4);
        if (row.kind == Kind::Enum) {
            std::size_t longest = 0;
            for (const EnumRow& choice : row.choices)
                longest = std::max(longest, choice.name.size());
            for (const EnumRow& choice : row.choices) {
                out.append(6, ' ').append(choice.name);
                out += wrapped(choice.help, longest + 8, longest + 2 - choice.name.size());
            }
        } else {
            out += fmt::format("    Accepts {}.\n", describeAccepted(row));
        }
        if (hasElements(row))
            out += fmt::format("    One element is {}[].\n", path);
        if (const std::string call = callFor(row, Unit().target); !call.empty())
            out += fmt::format("    {}\n", call);
        out += "\n";
    };
    walkAll({param, list}, filter);
    if (!out.empty())
        out.pop_back();
    return out;
}

std::string listParamsJson(const ParamFilter& filter) {
    OrderedJson params = OrderedJson::array();
    OrderedJson lists = OrderedJson::array();
    const auto list = [&](const std::string& path, const ChildRow& child) {
        lists.push_back({{"path", path}, {"minCount", child.minCount}, {"maxCount", child.maxCount}});
    };
    const auto param = [&](const std::string& path, const ParamRow& row, const Value& initial) {
        OrderedJson entry{{"path", path},
                          {"kind", kindName(row.kind)},
                          {"group", row.group},
                          {"label", row.label},
                          {"help", row.help},
                          {"glCall", callFor(row, Unit().target)},
                          {"default", jsonValue(row, initial)}};
        if (hasRange(row.kind))
            entry["range"] = {{"min", row.range.min},
                              {"max", row.range.max},
                              {"step", row.range.step},
                              {"unit", row.range.unit}};
        for (const EnumRow& choice : row.choices)
            entry["choices"].push_back({{"name", choice.name},
                                        {"label", choice.label},
                                        {"help", choice.help},
                                        {"since", choice.since}});
        params.push_back(std::move(entry));
    };
    walkAll({param, list}, filter);
    if (params.empty())
        return {};
    const OrderedJson all{
        {"version", sceneFormatVersion}, {"parameters", std::move(params)}, {"lists", std::move(lists)}};
    return all.dump(2) + "\n";
}

} // namespace texplorer
