#include "texplorer/emit/code_writer.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/base/translatable.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cctype>
#include <tuple>
#include <utility>

namespace texplorer::emit {
namespace {

constexpr std::string_view between = ", "; // numbers
/// Why a parameter of a line that isn't of a frame doesn't move.
constexpr const char* setOnce = N_("it is set only when the program starts");

bool isVector(Kind kind) {
    return kind == Kind::Vec3 || kind == Kind::Vec4 || kind == Kind::Color;
}

/// glLightfv takes a pointer to its numbers, glColor4f takes them one by one.
bool takesPointer(std::string_view callText) {
    return callText.substr(0, callText.find('(')).ends_with('v');
}

/// GLU's functions take doubles.
Literal literalOf(std::string_view callText) {
    return callText.starts_with("glu") ? Literal::Double : Literal::Float;
}

std::span<const float> numbersOf(const Value& value) {
    if (const auto* three = std::get_if<glm::vec3>(&value))
        return {&three->x, 3};
    if (const auto* four = std::get_if<glm::vec4>(&value))
        return {&four->x, 4};
    return {};
}

/// glEnable or glDisable itself.
bool isEnabling(const Part& part) {
    return part.kind == Part::Kind::Switch && (part.text == "glEnable" || part.text == "glDisable");
}

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// A value where a call takes it.
std::vector<Part> valueParts(const ParamRow& row, const Value& value, const std::string& path,
                             std::string_view callText, bool negated) {
    switch (row.kind) {
    case Kind::Bool: {
        return {{Part::Kind::Switch, std::string(booleanName(std::get<bool>(value))), path}};
    }
    case Kind::Int:
        return {whole(std::get<int>(value), path)};
    case Kind::Float: {
        const float one = std::get<float>(value);
        return numbers({&one, 1}, path, literalOf(callText), negated);
    }
    case Kind::Vec3:
    case Kind::Vec4:
    case Kind::Color:
        return numbers(numbersOf(value), path, literalOf(callText), negated);
    case Kind::Enum: {
        const EnumRow* found = findRow(row.choices, std::get<EnumValue>(value).number);
        return {choice(found ? found->name : "0", path)};
    }
    default:
        return {};
    }
}

/// The brackets of a row's call, with its value and those of the rows beside it: "({}, alphaRef);".
std::vector<Part> argumentsOf(const Holder& holder, const ParamRow& own, std::string_view words) {
    return filled(words, [&](std::string_view word) -> std::optional<std::vector<Part>> {
        const bool isOwn = word.ends_with("{}");
        const ParamRow* row = isOwn ? &own : findParam(holder.table, word);
        if (!row)
            return std::nullopt;
        const std::string path = fmt::format("{}.{}", holder.path, row->key);
        if (takesPointer(own.glCall) && isVector(row->kind))
            return std::vector<Part>{{Part::Kind::Plain, joined(holder.variable, row->key), path}};
        return valueParts(*row, row->read(holder.values), path, own.glCall, word.starts_with('-'));
    });
}

} // namespace

std::string literal(float number, Literal as) {
    std::string text = formatNumber(number == 0 ? 0 : number); // 0 has no sign
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return as == Literal::Float ? text + "f" : text;
}

Part plain(std::string text) {
    return {Part::Kind::Plain, std::move(text)};
}

Part call(std::string_view name) {
    return {Part::Kind::Call, std::string(name)};
}

Part number(float value, std::string path, int component, Literal as) {
    return {path.empty() ? Part::Kind::Plain : Part::Kind::Number, literal(value, as), std::move(path),
            component};
}

Part whole(int value, std::string path) {
    return {path.empty() ? Part::Kind::Plain : Part::Kind::Number, fmt::format("{}", value), std::move(path)};
}

Part choice(std::string_view name, std::string path) {
    return {Part::Kind::Choice, std::string(name), std::move(path)};
}

Part enabling(bool on, std::string path) {
    return {Part::Kind::Switch, on ? "glEnable" : "glDisable", std::move(path)};
}

std::vector<Part> numbers(std::span<const float> values, const std::string& path, Literal as, bool negated) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0)
            parts.push_back(plain(std::string(between)));
        const float value = negated ? 0 - values[i] : values[i]; // not -value: 0 has no sign
        parts.push_back(number(value, path, values.size() > 1 ? static_cast<int>(i) : -1, as));
        parts.back().negated = negated;
    }
    return parts;
}

std::vector<Part> doubles(const glm::dmat4& matrix) {
    std::vector<Part> parts;
    for (int i = 0; i < 16; ++i) {
        if (i > 0)
            parts.push_back(plain(std::string(between)));
        parts.push_back(plain(fmt::format("{}", glm::value_ptr(matrix)[i])));
    }
    return parts;
}

std::vector<Part> callWith(std::string_view name, std::vector<Part> arguments) {
    std::vector<Part> parts{call(name), plain("(")};
    append(parts, std::move(arguments));
    parts.push_back(plain(");"));
    return parts;
}

void append(std::vector<Part>& parts, std::vector<Part> more) {
    std::ranges::move(more, std::back_inserter(parts));
}

std::string joined(std::string_view first, std::string_view second) {
    std::string text(second);
    if (!first.empty())
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return std::string(first) + text;
}

std::vector<Part>
filled(std::string_view words,
       const std::function<std::optional<std::vector<Part>>(std::string_view word)>& resolve) {
    std::vector<Part> parts;
    std::string text;
    while (!words.empty()) {
        std::size_t length = words.starts_with("{}") ? 2 : words.starts_with("-{}") ? 3 : 0;
        while (length < words.size() && isWordCharacter(words[length]) && !words.starts_with("{}") &&
               !words.starts_with("-{}"))
            ++length;
        std::optional<std::vector<Part>> value = length > 0 ? resolve(words.substr(0, length)) : std::nullopt;
        length = std::max<std::size_t>(length, 1);
        if (value) {
            parts.push_back(plain(std::exchange(text, {})));
            append(parts, std::move(*value));
        } else {
            text += words.substr(0, length);
        }
        words.remove_prefix(length);
    }
    parts.push_back(plain(std::move(text)));
    std::erase_if(parts, [](const Part& part) { return part.text.empty(); });
    return parts;
}

std::string stringLiteral(std::string_view words) {
    std::string text = "\"";
    for (const char c : printable(words)) {
        if (c == '"' || c == '\\')
            text += '\\';
        text += c;
        if (text.ends_with("??")) // which C99 reads as the beginning of a trigraph
            text.insert(text.size() - 1, "\\");
    }
    return text + "\"";
}

std::string inComment(std::string_view words) {
    const std::string clean = printable(words);
    std::string text;
    for (const char c : clean) {
        const char last = text.empty() ? ' ' : text.back();
        const bool joins =
            (last == '*' && c == '/') || (last == '/' && c == '*') || (last == '?' && c == '?');
        text += joins ? std::string{' ', c} : std::string{c};
    }
    if (text.ends_with('*') || text.ends_with('/'))
        text += ' ';
    return text;
}

std::vector<Line> linesOf(std::string_view text) {
    std::vector<Line> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        const bool isComment = line.starts_with("/*") || line.starts_with(" *");
        lines.push_back({{{isComment ? Part::Kind::Comment : Part::Kind::Plain, std::string(line)}}});
        lines.back().depth = line.starts_with(' ') || line.starts_with('}') || line.starts_with('{') ? 1 : 0;
        lines.back().heading = line.starts_with("/*");
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

void CodeWriter::open(std::string_view head) {
    arrays_.clear();
    add({plain(std::string(head))});
    add({plain("{")});
    ++depth_;
}

void CodeWriter::close(std::string_view brace) {
    --depth_;
    add({plain(std::string(brace))});
    arrays_.clear();
}

void CodeWriter::heading(std::string_view words) {
    comment(words, false);
    lines_.back().heading = true;
}

void CodeWriter::comment(std::string_view words, bool needed) {
    add({{Part::Kind::Comment, fmt::format("/* {} */", inComment(words))}}, needed);
}

void CodeWriter::add(std::vector<Part> parts, bool needed) {
    const auto switches = [&](const Part& part) { return isEnabling(part) && moves(part.path); };
    if (const auto found = std::ranges::find_if(parts, switches); found != parts.end())
        return addSwitch(static_cast<std::size_t>(found - parts.begin()), parts, needed);
    needed |= resolve(parts);
    if (depth_ > 0)
        parts.insert(parts.begin(), plain(std::string(4 * static_cast<std::size_t>(depth_), ' ')));
    lines_.push_back({std::move(parts), needed});
    lines_.back().depth = depth_;
}

void CodeWriter::addSwitch(std::size_t enabling, const std::vector<Part>& parts, bool needed) {
    const std::string path = parts[enabling].path;
    if (taking_ == Taking::Still)
        return keys_->refuse(path, setOnce);
    add({plain("if ("), {Part::Kind::Plain, keys_->use(path), path}, plain(")")}, needed);
    for (const char* function : {"glEnable", "glDisable"}) {
        std::vector<Part> called = parts;
        called[enabling] = call(function);
        indent();
        add(std::move(called), needed);
        outdent();
        if (function == std::string_view("glEnable"))
            add("else", needed);
    }
}

bool CodeWriter::movesAny(const std::vector<Part>& parts) const {
    return std::ranges::any_of(parts, [&](const Part& part) { return moves(part.path); });
}

void CodeWriter::leave(const std::vector<Part>& parts) {
    for (const Part& part : parts)
        if (moves(part.path))
            keys_->leave(part.path);
}

bool CodeWriter::resolve(std::vector<Part>& parts) {
    bool found = false;
    for (Part& part : parts) {
        if (part.kind == Part::Kind::Call || part.path.empty() || !moves(part.path))
            continue;
        found = true;
        if (taking_ == Taking::Still)
            keys_->refuse(part.path, setOnce);
        else
            keys_->replace(part);
    }
    return found;
}

Value CodeWriter::valueOf(const std::string& path, const Value& still) const {
    return moves(path) ? Value("as the keys of " + path + " say") : still;
}

void CodeWriter::truncate(std::size_t size) {
    lines_.resize(size);
    std::erase_if(arrays_, [&](const auto& array) { return array.second >= size; });
}

void CodeWriter::add(std::string_view statement, bool needed) {
    const std::size_t bracket = statement.find('(');
    if (bracket == std::string_view::npos || !statement.starts_with("gl"))
        return add({plain(std::string(statement))}, needed);
    add({call(statement.substr(0, bracket)), plain(std::string(statement.substr(bracket)))}, needed);
}

void CodeWriter::data(std::string_view declaration, std::size_t count, Numbers numbers) {
    add({plain(fmt::format("{} = {{", declaration)),
         {Part::Kind::Comment, fmt::format("/* {} numbers */", count)},
         plain("};")});
    lines_.back().data = std::make_shared<const Numbers>(std::move(numbers));
}

bool CodeWriter::differs(const Holder& holder, const ParamRow& row) const {
    const auto known = state_.find(fmt::format("{}.{}", holder.state, row.key));
    return valueOf(fmt::format("{}.{}", holder.path, row.key), row.read(holder.values)) !=
           (known == state_.end() ? row.read(holder.initial) : known->second);
}

bool CodeWriter::set(const std::string& state, const Value& value, const Value& initial) {
    initial_.try_emplace(state, initial);
    const auto [known, isNew] = state_.try_emplace(state, initial);
    const bool differs = known->second != value;
    known->second = value;
    return differs;
}

Part CodeWriter::seconds() {
    ++secondsUses_;
    return plain("seconds");
}

void CodeWriter::floats(const std::string& name, std::vector<Part> values, bool needed) {
    const auto [known, isNew] = arrays_.try_emplace(name, lines_.size());
    if (!isNew) {
        for (std::size_t i = known->second; i < lines_.size(); ++i) {
            lines_[i].needed |= needed;
            if (textOf(lines_[i]).ends_with("};"))
                break;
        }
        return;
    }
    const std::string head = fmt::format("const GLfloat {}[] = {{", name);
    if (std::ranges::count(values, between, &Part::text) == 15)
        return matrix(head, std::move(values), "};", needed);
    std::vector<Part> parts{plain(head)};
    append(parts, std::move(values));
    parts.push_back(plain("};"));
    add(std::move(parts), needed);
}

void CodeWriter::matrix(std::string_view head, std::vector<Part> values, std::string_view end, bool needed) {
    add(head, needed);
    indent();
    std::vector<Part> column;
    int written = 0;
    for (Part& part : values) {
        const bool isNumber = part.text != between;
        if (isNumber || !column.empty())
            column.push_back(std::move(part));
        if (isNumber && ++written % 4 == 0) {
            column.push_back(plain(","));
            add(std::exchange(column, {}), needed);
        }
    }
    outdent();
    add(end, needed);
}

void CodeWriter::row(const Holder& holder, const ParamRow& row, bool matters) {
    const std::string path = fmt::format("{}.{}", holder.path, row.key);
    const bool isExplained = explained_.contains(path); // then it is said, even where OpenGL has it already
    const std::string words = callFor(row, holder.target);
    const std::size_t bracket = words.find('(');
    const std::string name = words.substr(0, bracket);
    std::vector<Part> parts = argumentsOf(holder, row, words.substr(bracket) + ";");
    const Value value = row.read(holder.values);
    const bool switches = row.kind == Kind::Bool && name == "glEnable";
    parts.insert(parts.begin(), switches ? enabling(std::get<bool>(value), path) : call(name));
    if (parts.front().kind == Part::Kind::Call)
        parts.front().path = path;
    if (!matters && movesAny(parts))
        return;
    if (!takes(parts)) {
        if (taking_ == Taking::Still)
            leave(parts);
        return;
    }
    const bool differs =
        set(fmt::format("{}.{}", holder.state, row.key), valueOf(path, value), row.read(holder.initial));
    bool needed = (differs || isExplained) && matters;
    if (switches && moves(path)) {
        if (needed && isExplained)
            comment(row.help);
        return needed ? addSwitch(0, parts, true) : void();
    }
    if (const bool isMoving = resolve(parts); !moves(path)) // what stands beside it in the call may
        needed |= isMoving;
    if (depth_ > 0)
        parts.insert(parts.begin(), plain(std::string(4 * static_cast<std::size_t>(depth_), ' ')));
    Line line{std::move(parts), needed};
    line.depth = depth_;
    if (!lines_.empty() && textOf(lines_.back()) == textOf(line)) { // two parameters of one call
        lines_.back().needed |= needed;
        return;
    }
    if (isExplained)
        comment(row.help, needed);
    if (takesPointer(words) && isVector(row.kind) && !moves(path))
        floats(joined(holder.variable, row.key), numbers(numbersOf(value), path), needed);
    lines_.push_back(std::move(line));
}

void CodeWriter::row(const Holder& holder, MemberId member) {
    const auto found = std::ranges::find(holder.table.params, member, &ParamRow::member);
    if (found != holder.table.params.end())
        row(holder, *found);
}

void finish(std::vector<Line>& lines) {
    std::map<std::tuple<std::string, int, Part::Kind>, int> counts;
    Line* last = nullptr;
    for (Line& line : lines) {
        for (Part& part : line.parts) {
            if (!part.path.empty())
                part.occurrence = counts[{part.path, part.component, part.kind}]++;
        }
        if (last && line.depth < last->depth)
            last = nullptr;
        if (line.heading) {
            last = &line;
            line.needed = false;
        } else if (last)
            last->needed |= line.needed;
    }
}

} // namespace texplorer::emit
