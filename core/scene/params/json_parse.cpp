// Reads a scene while the text is parsed, without a document in between: every token is held against the
// tables at once. What the tables don't foresee ends the reading there, so that neither deep nesting nor long
// lists can cost more memory than a scene may have.

#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/json_problem.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_check.h"
#include "texplorer/text/json_encoding.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace texplorer {
namespace {

/// Numbers are read as float at once: by way of double some would be rounded twice.
using FloatJson =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

/// How many numbers an array for this kind has, or each of its elements; none where it is no array of
/// numbers.
ElementNumbers numbersOf(Kind kind) {
    switch (kind) {
    case Kind::Vec3:
        return {3, 3};
    case Kind::Vec4:
    case Kind::Color:
        return {4, 4};
    case Kind::Matrix:
        return {16, 16};
    default:
        return elementNumbers(kind).value_or(ElementNumbers{0, 0});
    }
}

/// The value of a key frame is a text that may stand as what it spells: a number, true, an array of numbers.
bool isKeyValue(const ParamRow* row) {
    return row && row->member == memberId<&KeyFrame::value>;
}
constexpr std::size_t maxNumbersOfKey = 16; // of such an array: a matrix

/// An object or array that has begun and not ended.
struct Frame {
    enum class Kind { Object, List, Numbers, Elements, Indices };

    Kind kind;
    void* owner;                        ///< the struct that the object, or the member, belongs to
    const StructTable* table = nullptr; ///< Object: its members
    const ParamRow* row = nullptr;      ///< Object: the member that comes next; else what the numbers are for
    const ChildRow* child = nullptr;    ///< Object: the member that comes next; List: what its elements are
    bool versionNext = false;           ///< Object: what comes next is the version
    bool schemaNext = false;            ///< Object: what comes next names a schema, and is not looked at
    std::string key{};                  ///< Object: the last key, for the pointer
    std::uint64_t seen = 0;             ///< Object: one bit for each member that occurred
    std::size_t count = 0;              ///< elements so far
    std::array<float, 16> numbers{};    ///< Numbers
    std::vector<glm::vec4> elements{};  ///< Elements
    std::vector<int> indices{};         ///< Indices
};

class Reader : public nlohmann::json_sax<FloatJson> {
public:
    Reader(Scene& scene, std::string_view text)
        : scene_(scene)
        , text_(text) {}

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

    bool null() override { return refuse("null"); }
    bool boolean(bool value) override {
        const ParamRow* row = rowNext();
        if (isKeyValue(row))
            return store(*row, std::string(value ? "true" : "false"));
        if (!row || row->kind != Kind::Bool)
            return refuse(value ? "true" : "false");
        return store(*row, value);
    }
    bool number_integer(std::int64_t value) override {
        return number(static_cast<float>(value), value, std::to_string(value));
    }
    bool number_unsigned(std::uint64_t value) override {
        std::optional<std::int64_t> whole;
        if (value <= INT64_MAX)
            whole = static_cast<std::int64_t>(value);
        return number(static_cast<float>(value), whole, std::to_string(value));
    }
    bool number_float(float value, const std::string& text) override {
        std::optional<std::int64_t> whole;
        if (std::trunc(value) == value && std::abs(value) <= 1e9F)
            whole = static_cast<std::int64_t>(value);
        return number(value, whole, shortened(text));
    }
    bool string(std::string& value) override;
    bool binary(FloatJson::binary_t&) override { return refuse("binary data"); } // JSON has none
    bool start_object(std::size_t) override;
    bool key(std::string& key) override;
    bool end_object() override;
    bool start_array(std::size_t) override;
    bool end_array() override;
    bool parse_error(std::size_t position, const std::string& token,
                     const FloatJson::exception& problem) override;

private:
    /// The parameter that a scalar or an array of numbers would be for; nullptr where none may come.
    const ParamRow* rowNext() const {
        return !frames_.empty() && frames_.back().kind == Frame::Kind::Object ? frames_.back().row : nullptr;
    }

    bool number(float value, std::optional<std::int64_t> whole, const std::string& text);
    bool numbersEnded(const Frame& ended);
    bool version(std::optional<std::int64_t> number, const std::string& text);
    bool store(const ParamRow& row, const Value& value);
    Sentence expected() const;
    std::string pointer() const;

    bool stop(ErrorCode code, Sentence message) {
        error_ = Error{code, std::move(message), atPointer(pointer())};
        return false;
    }
    bool tooMany(std::size_t limit) {
        return stop(ErrorCode::TooLarge, Sentence("expected at most {0} elements, found more", limit));
    }
    bool refuse(const std::string& found) {
        return stop(ErrorCode::OutOfRange, Sentence("expected {0}, found {1}", expected(), found));
    }

    Scene& scene_;
    std::string_view text_;
    std::vector<Frame> frames_;
    std::optional<Error> error_;
};

std::string Reader::pointer() const {
    std::string text;
    for (const Frame& frame : frames_) {
        if (frame.kind != Frame::Kind::Object)
            text += fmt::format("/{}", frame.count);
        else if (!frame.key.empty())
            text += "/" + pointerStep(shortened(frame.key));
    }
    return text;
}

Sentence Reader::expected() const {
    if (frames_.empty())
        return "an object";
    const Frame& frame = frames_.back();
    switch (frame.kind) {
    case Frame::Kind::Object:
        if (frame.versionNext)
            return Sentence("version {0}", sceneFormatVersion);
        if (frame.schemaNext)
            return N_("a text");
        if (frame.row)
            return describeAccepted(*frame.row);
        return frame.child->indexed ? "an array" : "an object";
    case Frame::Kind::List:
        return "an object";
    case Frame::Kind::Numbers:
        return N_("a number between -3.4e38 and 3.4e38");
    case Frame::Kind::Elements: {
        const ElementNumbers numbers = *elementNumbers(frame.row->kind);
        return numbers.min == numbers.max
                   ? Sentence("an array of {0} numbers", numbers.max)
                   : Sentence("an array of {0} to {1} numbers", numbers.min, numbers.max);
    }
    case Frame::Kind::Indices:
        return N_("a whole number");
    }
    return {};
}

bool Reader::store(const ParamRow& row, const Value& value) {
    if (auto checked = checkValue(row, value); !checked)
        return stop(checked.error().code, checked.error().message);
    row.write(frames_.back().owner, value);
    return true;
}

bool Reader::version(std::optional<std::int64_t> number, const std::string& text) {
    if (number && *number > sceneFormatVersion)
        return stop(ErrorCode::Unsupported,
                    Sentence("the file has version {0}, but this Texplorer reads versions up to {1}", text,
                             sceneFormatVersion));
    return number && *number >= 1 ? true : refuse(text);
}

bool Reader::number(float value, std::optional<std::int64_t> whole, const std::string& text) {
    if (!frames_.empty() && frames_.back().kind == Frame::Kind::Numbers) {
        Frame& frame = frames_.back();
        const std::size_t limit = isKeyValue(frame.row) ? maxNumbersOfKey : numbersOf(frame.row->kind).max;
        if (frame.count == limit)
            return stop(ErrorCode::OutOfRange,
                        Sentence("expected {0}, found more than {1}", describeAccepted(*frame.row), limit));
        frame.numbers[frame.count++] = value;
        return true;
    }
    if (!frames_.empty() && frames_.back().kind == Frame::Kind::Indices) {
        Frame& frame = frames_.back();
        if (!whole || *whole < 0 || *whole > INT32_MAX)
            return refuse(text);
        if (frame.count == frame.row->maxCount)
            return tooMany(frame.row->maxCount);
        frame.indices.push_back(static_cast<int>(*whole));
        ++frame.count;
        return true;
    }
    if (!frames_.empty() && frames_.back().versionNext)
        return version(whole, text);
    const ParamRow* row = rowNext();
    if (isKeyValue(row))
        return store(*row, whole ? std::to_string(*whole) : formatNumber(value));
    if (row && row->kind == Kind::Float)
        return store(*row, value);
    if (row && row->kind == Kind::Int && whole && *whole >= INT32_MIN && *whole <= INT32_MAX)
        return store(*row, static_cast<int>(*whole));
    // Some names are numbers: GL_RGB_SCALE is 1, 2 or 4.
    if (row && row->kind == Kind::Enum && whole)
        if (const EnumRow* named = findRow(row->choices, std::to_string(whole.value_or(0))))
            return store(*row, EnumValue{named->value});
    return refuse(text);
}

bool Reader::string(std::string& value) {
    if (!frames_.empty() && frames_.back().schemaNext)
        return true;
    const ParamRow* row = rowNext();
    if (!row || (row->kind != Kind::Enum && row->kind != Kind::Text))
        return refuse(inQuotes(value));
    const auto parsed = parseValue(*row, value);
    return parsed ? store(*row, *parsed) : stop(parsed.error().code, parsed.error().message);
}

bool Reader::start_object(std::size_t) {
    if (frames_.empty()) {
        frames_.push_back({.kind = Frame::Kind::Object, .owner = &scene_, .table = &sceneTable()});
        return true;
    }
    Frame& frame = frames_.back();
    const ChildRow* child = frame.child;
    std::size_t index = 0;
    if (frame.kind == Frame::Kind::List) {
        index = frame.count;
        if (index == child->maxCount)
            return tooMany(child->maxCount);
        if (child->minCount != child->maxCount)
            child->resize(frame.owner, index + 1);
    } else if (frame.kind != Frame::Kind::Object || !child || child->indexed) {
        return refuse("an object");
    }
    void* owner = child->at(frame.owner, index);
    frames_.push_back({.kind = Frame::Kind::Object, .owner = owner, .table = child->table});
    return true;
}

bool Reader::key(std::string& key) {
    Frame& frame = frames_.back();
    const bool root = frames_.size() == 1;
    frame.key = key;
    frame.row = findParam(*frame.table, key);
    frame.child = findChild(*frame.table, key);
    frame.versionNext = root && key == versionKey;
    frame.schemaNext = root && key == schemaKey;

    std::size_t bit = frame.schemaNext ? 62 : 63;
    if (frame.row)
        bit = static_cast<std::size_t>(frame.row - frame.table->params.data());
    else if (frame.child)
        bit =
            frame.table->params.size() + static_cast<std::size_t>(frame.child - frame.table->children.data());
    else if (!frame.versionNext && !frame.schemaNext) {
        auto names = tableKeys(*frame.table);
        if (root)
            names.insert(names.begin(), versionKey);
        return stop(ErrorCode::OutOfRange, Sentence("unknown key; {0}", suggestName(key, names)));
    }
    if ((frame.seen >> bit & 1U) != 0)
        return stop(ErrorCode::Malformed, Sentence("expected each key once, found {0} twice", inQuotes(key)));
    frame.seen |= std::uint64_t{1} << bit;
    return true;
}

bool Reader::start_array(std::size_t) {
    if (frames_.empty())
        return refuse("an array");
    Frame& frame = frames_.back();
    if (frame.kind == Frame::Kind::Elements) {
        if (frame.count == frame.row->maxCount)
            return tooMany(frame.row->maxCount);
        frames_.push_back({.kind = Frame::Kind::Numbers, .owner = frame.owner, .row = frame.row});
        return true;
    }
    if (frame.kind == Frame::Kind::Object && frame.child && frame.child->indexed) {
        frame.child->resize(frame.owner, 0); // a list that is present replaces what was there
        frames_.push_back({.kind = Frame::Kind::List, .owner = frame.owner, .child = frame.child});
        return true;
    }
    const ParamRow* row = rowNext();
    if (row && isList(row->kind)) {
        const auto kind = row->kind == Kind::IndexList ? Frame::Kind::Indices : Frame::Kind::Elements;
        frames_.push_back({.kind = kind, .owner = frame.owner, .row = row});
        return true;
    }
    if (row && (numbersOf(row->kind).max > 0 || isKeyValue(row))) {
        frames_.push_back({.kind = Frame::Kind::Numbers, .owner = frame.owner, .row = row});
        return true;
    }
    return refuse("an array");
}

bool Reader::end_object() {
    frames_.pop_back();
    if (!frames_.empty() && frames_.back().kind == Frame::Kind::List)
        ++frames_.back().count;
    return true;
}

bool Reader::end_array() {
    const Frame ended = std::move(frames_.back());
    frames_.pop_back(); // so that an error points at the array, not beyond its end
    switch (ended.kind) {
    case Frame::Kind::Object:
        break;
    case Frame::Kind::List:
        if (ended.child->minCount != ended.child->maxCount && ended.count < ended.child->minCount)
            return stop(ErrorCode::OutOfRange,
                        Sentence("expected {0} to {1} elements, found {2}", ended.child->minCount,
                                 ended.child->maxCount, ended.count));
        break;
    case Frame::Kind::Elements:
        return store(*ended.row, listOf(ended.row->kind, ended.elements));
    case Frame::Kind::Indices:
        // Kept apart from a pass that says nothing, which draws all.
        if (ended.indices.empty() && ended.row->member == memberId<&Pass::models>)
            return refuse("an empty array; a pass without a list of models draws all");
        return store(*ended.row, ended.indices);
    case Frame::Kind::Numbers:
        return numbersEnded(ended);
    }
    return true;
}

bool Reader::numbersEnded(const Frame& ended) {
    if (isKeyValue(ended.row))
        return store(*ended.row, formatNumbers({ended.numbers.data(), ended.count}));
    const ElementNumbers expected = numbersOf(ended.row->kind);
    if (ended.count < expected.min)
        return refuse(std::to_string(ended.count));
    glm::vec4 first = expected.rest;
    std::copy_n(ended.numbers.begin(), std::min<std::size_t>(ended.count, 4), &first.x);
    switch (ended.row->kind) {
    case Kind::Vec3:
        return store(*ended.row, glm::vec3(first));
    case Kind::Vec4:
    case Kind::Color:
        return store(*ended.row, first);
    case Kind::Matrix:
        return store(*ended.row, glm::make_mat4(ended.numbers.data()));
    default:
        frames_.back().elements.push_back(first);
        ++frames_.back().count;
        return true;
    }
}

bool Reader::parse_error(std::size_t position, const std::string& token,
                         const FloatJson::exception& problem) {
    constexpr int numberOverflow = 406;
    if (problem.id == numberOverflow)
        return refuse(shortened(token));

    JsonProblem found = jsonProblem(text_, problem.id, position);
    error_ = Error{ErrorCode::Malformed, std::move(found.message), found.where};
    return false;
}

} // namespace

Result<Scene> parseScene(std::string_view json) {
    if (json.size() > maxSceneBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected a scene of at most {0} bytes, found {1}", maxSceneBytes, json.size()));
    if (json.empty())
        return fail(ErrorCode::Malformed, "expected an object, found an empty file");

    if (const Result<void> whole = checkEncoding(json); !whole)
        return fail(whole.error());

    Scene scene = defaultScene();
    Reader reader(scene, json);
    const bool parsed = FloatJson::sax_parse(json.begin(), json.end(), &reader);
    if (reader.error())
        return fail(*reader.error());
    if (!parsed)
        return fail(ErrorCode::Malformed, "expected a scene in JSON");
    if (auto checked = checkTogether(scene); !checked)
        return fail(std::move(checked.error()));
    for (Model& model : scene.models) {
        if (MeshData& mesh = model.mesh; !mesh.file.empty()) // its lists are the file's
            mesh = {.primitive = mesh.primitive, .file = mesh.file, .part = mesh.part};
    }
    return scene;
}

} // namespace texplorer
