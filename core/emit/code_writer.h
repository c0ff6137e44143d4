#pragma once

#include "texplorer/emit/code.h"
#include "texplorer/emit/key_frames.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/scene/params/params.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::emit {

/// How C writes a number: "0.5f", "0.5".
enum class Literal : std::uint8_t { Float, Double };
[[nodiscard]] std::string literal(float number, Literal as);

[[nodiscard]] Part plain(std::string text);
[[nodiscard]] Part call(std::string_view name);
[[nodiscard]] Part number(float value, std::string path = {}, int component = -1,
                          Literal as = Literal::Float);
[[nodiscard]] Part whole(int value, std::string path = {});
[[nodiscard]] Part choice(std::string_view name, std::string path);
/// glEnable or glDisable.
[[nodiscard]] Part enabling(bool on, std::string path);

/// "1.0f, 2.0f, 3.0f".
[[nodiscard]] std::vector<Part> numbers(std::span<const float> values, const std::string& path = {},
                                        Literal as = Literal::Float, bool negated = false);

/// Its 16 numbers, as numbers() gives them.
[[nodiscard]] std::vector<Part> doubles(const glm::dmat4& matrix);

/// "glTranslatef(", the arguments, ");".
[[nodiscard]] std::vector<Part> callWith(std::string_view name, std::vector<Part> arguments);

void append(std::vector<Part>& parts, std::vector<Part> more);

/// What a row's call has in its brackets, "({}, alphaRef);": `resolve` is asked for each name and for the two
/// places of the value, "{}" and "-{}"; what it doesn't know stays as it is.
[[nodiscard]] std::vector<Part>
filled(std::string_view words,
       const std::function<std::optional<std::vector<Part>>(std::string_view word)>& resolve);

/// Two words as one name, "unit1EnvColor".
[[nodiscard]] std::string joined(std::string_view first, std::string_view second);

/// A struct of the scene whose rows are written.
struct Holder {
    const StructTable& table;
    const void* values;
    const void* initial;  ///< with what OpenGL starts with
    std::string path;     ///< "passes[0].units[1]"
    std::string state;    ///< the part of OpenGL's state that it sets, the same for all passes: "units[1]"
    std::string variable; ///< what names of variables begin with: "unit1"
    Target target = Target::Texture2D;
};

/// A pattern of C's own lines: a function that comes as it is.
[[nodiscard]] std::vector<Line> linesOf(std::string_view text);

/// Says which lines are needed and numbers the places of each value: of a whole program.
void finish(std::vector<Line>& lines);

/// Which lines are taken, where parameters move by key frames: what is set once leaves these to the frames,
/// and a frame may leave the others to what is set once.
enum class Taking : std::uint8_t { Still, All, Moving };

/// Collects lines, and knows what OpenGL's state is after them, so that it can tell which are needed.
class CodeWriter {
public:
    /// What moves of the scene that is written, which has to outlive the writer. Until take() says otherwise
    /// lines aren't of a frame: Taking::Still.
    void follow(KeyFrames& keys) { keys_ = &keys; }
    void take(Taking taking) { taking_ = taking; }
    [[nodiscard]] bool moves(std::string_view path) const { return keys_ && keys_->moves(path); }
    [[nodiscard]] bool movesBelow(std::string_view prefix) const {
        return keys_ && keys_->movesBelow(prefix);
    }
    /// Whether a line of these parts is taken.
    [[nodiscard]] bool takes(const std::vector<Part>& parts) const {
        return taking_ == Taking::All || movesAny(parts) == (taking_ == Taking::Moving);
    }

    /// "static void draw(void)" and a brace, up to close(): arrays that were declared before are others'.
    /// What follows is indented.
    void open(std::string_view head);
    void close(std::string_view brace = "}");
    /// A statement of its own below "for (…)".
    void indent() { ++depth_; }
    void outdent() { --depth_; }

    /// "/* … */"; a heading is needed where something below it is.
    void heading(std::string_view words);
    void comment(std::string_view words, bool needed = true);
    void add(std::vector<Part> parts, bool needed = true);
    /// A statement without values.
    void add(std::string_view statement, bool needed = true);

    /// Lines that come as they are.
    void add(const std::vector<Line>& lines) { lines_.insert(lines_.end(), lines.begin(), lines.end()); }

    /// The call of a row, and before it the array that it points to. What one call sets together with the row
    /// before is one line. `matters`: something that is drawn depends on it.
    void row(const Holder& holder, const ParamRow& row, bool matters = true);
    /// The same of the row of a member.
    void row(const Holder& holder, MemberId member);

    /// Whether the value of a row isn't what OpenGL has.
    [[nodiscard]] bool differs(const Holder& holder, const ParamRow& row) const;
    /// Whether a value isn't what OpenGL has, and from now on has.
    bool set(const std::string& state, const Value& value, const Value& initial);
    /// OpenGL may have anything.
    void forget(const std::string& state) { state_[state] = std::string(); }

    /// `seconds`, which draw() is then given.
    Part seconds();
    [[nodiscard]] bool usesSeconds() const { return secondsUses_ > 0; }
    /// How often so far.
    [[nodiscard]] int secondsUses() const { return secondsUses_; }

    /// Parameters whose calls are needed in any case, and have a word on what they do before them.
    void explain(std::set<std::string, std::less<>> paths) { explained_ = std::move(paths); }

    /// What is known of OpenGL's state.
    using State = std::map<std::string, Value, std::less<>>;
    [[nodiscard]] const State& state() const { return state_; }
    /// What OpenGL starts with, of everything in state().
    [[nodiscard]] const State& initialState() const { return initial_; }

    /// "GLfloat name[] = {…};", where there is no such array yet. A matrix has a row for each of its columns.
    void floats(const std::string& name, std::vector<Part> values, bool needed = true);

    /// 16 numbers, as numbers() gives them, between two lines: each column of theirs in a row.
    void matrix(std::string_view head, std::vector<Part> values, std::string_view end, bool needed = true);

    /// The array's name with all of its numbers, in a line of its own that shows none of them.
    void data(std::string_view declaration, std::size_t count, Numbers numbers);

    [[nodiscard]] std::vector<Line> take() && { return std::move(lines_); }

    [[nodiscard]] std::size_t size() const { return lines_.size(); }
    /// Takes back what was added since there were so many lines.
    void truncate(std::size_t size);

private:
    [[nodiscard]] bool movesAny(const std::vector<Part>& parts) const;
    /// Puts variables in the place of what moves. Whether there was any.
    bool resolve(std::vector<Part>& parts);
    /// What moves of a line that is left to the frames.
    void leave(const std::vector<Part>& parts);
    void addSwitch(std::size_t enabling, const std::vector<Part>& parts, bool needed);
    /// What OpenGL has where a parameter moves.
    [[nodiscard]] Value valueOf(const std::string& path, const Value& still) const;

    std::vector<Line> lines_;
    State state_;
    State initial_;
    std::set<std::string, std::less<>> explained_;
    int depth_ = 0;
    std::map<std::string, std::size_t, std::less<>> arrays_; ///< with which line each begins
    int secondsUses_ = 0;
    KeyFrames* keys_ = nullptr;
    Taking taking_ = Taking::Still;
};

/// A C string of one line, with nothing that isn't printable.
[[nodiscard]] std::string stringLiteral(std::string_view words);

/// Words that stand in a comment: none of them ends it.
[[nodiscard]] std::string inComment(std::string_view words);

} // namespace texplorer::emit
