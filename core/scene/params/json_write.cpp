// A scene as text. Written by hand rather than by a library for the sake of its readers: an array of numbers
// stays on one line, a long list fills its lines, and floats have the shortest digits that read back.

#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_check.h"
#include "texplorer/scene/params/scene_schema.h"
#include "texplorer/scene/params/timeline_check.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace texplorer {
namespace {

constexpr std::size_t lineLength = 110;

std::string jsonNumber(float number) {
    if (!std::isfinite(number))
        return "null"; // JSON has no word for it, and no row accepts it
    return number == 0 && std::signbit(number) ? "-0.0" : formatNumber(number); // -0 would read as an integer
}

std::string jsonNumbers(std::span<const float> numbers) {
    std::string text = "[";
    for (const float number : numbers)
        text.append(text.size() == 1 ? "" : ", ").append(jsonNumber(number));
    return text + "]";
}

std::string jsonText(std::string_view text) {
    using Json = nlohmann::json;
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Whether the text is just what formatNumber makes of the number that it spells.
bool isShortestNumber(std::string_view text) {
    float number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stop == text.data() + text.size() && std::isfinite(number) &&
           text != "-0" && formatNumber(number) == text;
}

bool isShortWholeNumber(std::string_view text) {
    return isShortestNumber(text) && text.find_first_not_of("-0123456789") == std::string_view::npos;
}

/// A key frame's value without quotes where it reads back as the same text: a number, true, numbers in a
/// row.
std::string keyValue(std::string_view text) {
    if (text == "true" || text == "false")
        return std::string(text);
    std::vector<std::string_view> parts;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        parts.push_back(rest.substr(0, comma));
        if (comma == std::string_view::npos)
            break;
        rest.remove_prefix(comma + 1);
    }
    constexpr std::size_t maxNumbers = 16; // a matrix
    if (parts.size() > maxNumbers || !std::ranges::all_of(parts, isShortestNumber))
        return jsonText(text);
    if (parts.size() > 1)
        return fmt::format("[{}]", fmt::join(parts, ", "));
    float number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    // A reader takes 1e+06 for the whole number that it is.
    return isShortWholeNumber(text) || std::trunc(number) != number ? std::string(text) : jsonText(text);
}

bool isSame(const StructTable& table, void* a, void* b);

bool isSameChild(const ChildRow& child, void* a, void* b) {
    if (child.size(a) != child.size(b))
        return false;
    for (std::size_t i = 0; i < child.size(a); ++i)
        if (!isSame(*child.table, child.at(a, i), child.at(b, i)))
            return false;
    return true;
}

bool isSame(const StructTable& table, void* a, void* b) {
    return std::ranges::all_of(table.params,
                               [&](const ParamRow& row) { return row.read(a) == row.read(b); }) &&
           std::ranges::all_of(table.children,
                               [&](const ChildRow& child) { return isSameChild(child, a, b); });
}

class Writer {
public:
    explicit Writer(const Scene& scene)
        : scene_(scene) {}

    /// `start`: what a file stands for that says nothing, which is left out; nullptr: nothing is. It is used
    /// up.
    std::string write(Scene* start) {
        open('{');
        if (!start) {
            member(schemaKey);
            out_ += jsonText(sceneSchemaId);
        }
        member(versionKey);
        out_ += std::to_string(sceneFormatVersion);
        members(sceneTable(),
                const_cast<Scene*>(&scene_), // the tables reach members through void*; only read
                start);
        close('}');
        return std::move(out_) + "\n";
    }

private:
    void members(const StructTable& table, void* owner, void* start) {
        for (const ParamRow& row : table.params)
            if (start == nullptr || row.read(owner) != row.read(start))
                param(row, owner);
        for (const ChildRow& child : table.children) {
            if ((child.member == memberId<&Scene::timeline> && child.size(owner) == 0) ||
                (child.member == memberId<&Model::units> &&
                 static_cast<Model*>(owner)->units == Model{}.units))
                continue; // most scenes have none
            // What a file leaves out of an element of a list reads as its default; out of the scene itself,
            // as the scene that one begins with has it.
            if (!child.indexed && &table != &sceneTable() && child.isDefault(owner, 0))
                continue;
            if (start != nullptr && isSameChild(child, owner, start))
                continue;
            member(child.key);
            if (child.indexed)
                list(child, owner, start);
            else
                object(*child.table, child.at(owner, 0), start == nullptr ? nullptr : child.at(start, 0));
        }
    }

    void object(const StructTable& table, void* owner, void* start) {
        open('{');
        members(table, owner, start);
        close('}');
    }

    void list(const ChildRow& child, void* owner, void* start) {
        std::size_t count = child.size(owner);
        const bool fixedArray = child.minCount == child.maxCount;
        while (fixedArray && count > 0 && child.isDefault(owner, count - 1))
            --count; // what a file leaves out at the end of an array reads as its default
        if (start !=
            nullptr) { // a list that is present replaces what was there: its elements begin as new ones
            child.resize(start, 0);
            child.resize(start, child.size(owner));
        }
        open('[');
        for (std::size_t i = 0; i < count; ++i) {
            line();
            object(*child.table, child.at(owner, i), start == nullptr ? nullptr : child.at(start, i));
        }
        close(']');
    }

    /// Whether a list fits the others of its struct, or the scene.
    bool listFits(const ParamRow& row, const void* owner) const {
        if (findParam(modelTable(), row.key) == &row)
            return checkVertexList(*static_cast<const Model*>(owner), row).has_value();
        if (row.member == memberId<&Pass::models>)
            return checkPassModels(scene_, *static_cast<const Pass*>(owner)).has_value();
        const auto& mesh = *static_cast<const MeshData*>(owner);
        return mesh.file.empty() && checkMeshList(mesh, row).has_value();
    }

    void param(const ParamRow& row, void* owner) {
        const Value value = row.read(owner);
        if (isList(row.kind) && (listSize(value) == 0 || !listFits(row, owner)))
            return; // what doesn't fit has no effect, and a reader would refuse it; a file has its own
        member(row.key);
        switch (row.kind) {
        case Kind::Bool:
        case Kind::Int:
            out_ += formatValue(row, value);
            break;
        case Kind::Float:
            out_ += jsonNumber(std::get<float>(value));
            break;
        case Kind::Vec3:
            out_ += jsonNumbers({&std::get<glm::vec3>(value).x, 3});
            break;
        case Kind::Vec4:
        case Kind::Color:
            out_ += jsonNumbers({&std::get<glm::vec4>(value).x, 4});
            break;
        case Kind::Enum:
        case Kind::Text:
            out_ += row.member == memberId<&KeyFrame::value> ? keyValue(std::get<std::string>(value))
                                                             : jsonText(formatValue(row, value));
            break;
        case Kind::Matrix:
            out_ += jsonNumbers({&std::get<glm::mat4>(value)[0].x, 16});
            break;
        case Kind::PointList:
        case Kind::ColorList:
        case Kind::TexCoordList: {
            const ElementNumbers numbers = *elementNumbers(row.kind);
            std::vector<std::string> elements;
            for (const glm::vec4& element : elementsOf(value))
                elements.push_back(jsonNumbers({&element.x, numbers.needed(element)}));
            filledLines(elements);
            break;
        }
        case Kind::IndexList: {
            std::vector<std::string> elements;
            for (const int index : std::get<SharedList<int>>(value))
                elements.push_back(std::to_string(index));
            filledLines(elements);
            break;
        }
        }
    }

    /// An array in the line that has begun, where it fits, else in lines with as many elements as they can
    /// hold.
    void filledLines(const std::vector<std::string>& elements) {
        const std::string all = fmt::format("[{}]", fmt::join(elements, ", "));
        if (column() + all.size() < lineLength) { // there may come a comma
            out_ += all;
            return;
        }
        open('[');
        for (const std::string& element : elements) {
            if (empty_ || column() + element.size() + 3 > lineLength) // ", " before it and a comma after it
                line();
            else
                out_ += ", ";
            out_ += element;
        }
        close(']');
    }

    /// How many bytes the last line has.
    [[nodiscard]] std::size_t column() const { return out_.size() - (out_.rfind('\n') + 1); }

    void open(char bracket) {
        out_ += bracket;
        ++depth_;
        empty_ = true;
    }

    void close(char bracket) {
        --depth_;
        if (!empty_)
            indent();
        out_ += bracket;
        empty_ = false;
    }

    /// Begins the next member or element.
    void line() {
        if (!empty_)
            out_ += ',';
        empty_ = false;
        indent();
    }

    void member(std::string_view key) {
        line();
        out_.append("\"").append(key).append("\": ");
    }

    void indent() { out_.append("\n").append(2 * depth_, ' '); }

    const Scene& scene_;
    std::string out_;
    std::size_t depth_ = 0;
    bool empty_ = true; ///< nothing was written yet since the last opening bracket
};

} // namespace

namespace {

/// Without the keys that don't fit the scene any more, as a reader would refuse them.
std::string writeFitting(const Scene& scene, Scene* start) {
    Timeline fitting = fittingTimeline(scene);
    if (fitting == scene.timeline)
        return Writer(scene).write(start);
    Scene fitted = scene;
    fitted.timeline = std::move(fitting);
    return Writer(fitted).write(start);
}

} // namespace

std::string writeScene(const Scene& scene) {
    return writeFitting(scene, nullptr);
}

std::string writeShortScene(const Scene& scene) {
    Scene start = defaultScene();
    return writeFitting(scene, &start);
}

} // namespace texplorer
