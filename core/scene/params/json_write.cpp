// A scene as text. Written by hand rather than by a library for the sake of its readers: an array of numbers
// stays on one line, and floats have the shortest digits that read back.

#include "core/scene/params/json.h"
#include "core/scene/params/param_text.h"
#include "core/scene/params/params.h"
#include "core/scene/params/scene_check.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace texplorer {
namespace {

std::string jsonNumber(float number) {
    if (!std::isfinite(number))
        return "null"; // JSON has no word for it, and no row accepts it
    return number == 0 && std::signbit(number) ? "-0.0" : formatNumber(number); // -0 would read as an integer
}

template<class Vector>
std::string jsonVector(const Vector& vector, int count) {
    std::string text = "[";
    for (int i = 0; i < count; ++i)
        text.append(i == 0 ? "" : ", ").append(jsonNumber(vector[i]));
    return text + "]";
}

std::string jsonText(std::string_view text) {
    using Json = nlohmann::json;
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

class Writer {
public:
    std::string write(const Scene& scene) {
        open('{');
        member("version");
        out_ += std::to_string(sceneFormatVersion);
        members(sceneTable(),
                const_cast<Scene*>(&scene)); // the tables reach members through void*; only read
        close('}');
        return std::move(out_) + "\n";
    }

private:
    void members(const StructTable& table, void* owner) {
        for (const ParamRow& row : table.params)
            param(row, owner);
        for (const ChildRow& child : table.children) {
            // What a file leaves out of an element of a list reads as its default; out of the scene itself,
            // as the scene that one begins with has it.
            if (!child.indexed && &table != &sceneTable() && child.isDefault(owner, 0))
                continue;
            member(child.key);
            if (child.indexed)
                list(child, owner);
            else
                object(*child.table, child.at(owner, 0));
        }
    }

    void object(const StructTable& table, void* owner) {
        open('{');
        members(table, owner);
        close('}');
    }

    void list(const ChildRow& child, void* owner) {
        std::size_t count = child.size(owner);
        const bool fixedArray = child.minCount == child.maxCount;
        while (fixedArray && count > 0 && child.isDefault(owner, count - 1))
            --count; // what a file leaves out at the end of an array reads as its default
        open('[');
        for (std::size_t i = 0; i < count; ++i) {
            line();
            object(*child.table, child.at(owner, i));
        }
        close(']');
    }

    void param(const ParamRow& row, void* owner) {
        const Value value = row.read(owner);
        if (row.kind == Kind::TexCoordList) {
            // A list that doesn't fit its mesh has no effect, and a reader would refuse it.
            const TexCoords& coords = std::get<TexCoords>(value);
            if (coords.empty() || !checkTexCoordCount(*static_cast<const Model*>(owner), coords))
                return;
        }
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
            out_ += jsonVector(std::get<glm::vec3>(value), 3);
            break;
        case Kind::Vec4:
        case Kind::Color:
            out_ += jsonVector(std::get<glm::vec4>(value), 4);
            break;
        case Kind::Enum:
        case Kind::Text:
            out_ += jsonText(formatValue(row, value));
            break;
        case Kind::TexCoordList:
            open('[');
            for (const glm::vec4& coord : std::get<TexCoords>(value)) {
                line();
                out_ += jsonVector(coord, coord.q != 1 ? 4 : coord.p != 0 ? 3 : 2);
            }
            close(']');
            break;
        }
    }

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

    std::string out_;
    std::size_t depth_ = 0;
    bool empty_ = true; ///< nothing was written yet since the last opening bracket
};

} // namespace

std::string writeScene(const Scene& scene) {
    return Writer().write(scene);
}

} // namespace texplorer
