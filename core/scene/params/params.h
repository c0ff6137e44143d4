#pragma once

// One row per editable parameter: the only place where its key, label, help and GL call are written.
// Panels, JSON, `--set`, `texshot params` and the command view walk these tables; none of them knows a
// parameter.

#include "core/base/result.h"
#include "core/gl/enum_row.h"
#include "core/scene/scene.h"

#include <functional>
#include <variant>

namespace texplorer {

/// An enumerator without its type; the row's `choices` say what it may be.
struct EnumValue {
    std::uint32_t number;
    bool operator==(const EnumValue&) const = default;
};

using Value = std::variant<bool, int, float, glm::vec3, glm::vec4, glm::mat4, EnumValue, std::string,
                           std::vector<glm::vec3>, std::vector<glm::vec4>, std::vector<int>>;

/// The lists have an element of 3, 3 to 4, or 2 to 4 numbers for each vertex; or whole numbers.
enum class Kind {
    Bool,
    Int,
    Float,
    Vec3,
    Vec4,
    Color,
    Matrix,
    Enum,
    Text,
    PointList,
    ColorList,
    TexCoordList,
    IndexList
};

/// The accepted numbers, both ends included, for each component; `step` is a drag of one pixel.
struct Range {
    float min = 0;
    float max = 1;
    float step = 0.01F;
    std::string_view unit = {}; ///< "deg", "deg/s", "texels"; empty for a plain number
    std::string_view initially =
        {}; ///< what the initial value stands for, where its number says nothing: "no limit"
};

/// Tells the members of all structs apart, whatever their types: `memberId<&Texture::minFilter>`.
using MemberId = const char*;
template<auto Member>
inline constexpr char memberMark = 0;
template<auto Member>
inline constexpr MemberId memberId = &memberMark<Member>;

struct ParamRow {
    MemberId member;
    std::string_view key;   ///< the JSON key and the last part of its path: "minFilter"
    std::string_view group; ///< the panel section it belongs to: "Filter"
    std::string_view label; ///< "Minification"
    std::string_view help;  ///< one or two sentences for a student
    /// The call that sets it, "{}" where the value goes; empty where GL has no such state. A call without
    /// "{}" is a glEnable, which glDisable takes back. Words that aren't GL's are keys beside this one:
    /// "glAlphaFunc({}, alphaRef)". What depends on a texture's target is in braces: "{target}" and the other
    /// words of gl_call.cpp.
    std::string_view glCall;
    Kind kind;
    Range range;                                    ///< for Int, Float, Vec3, Vec4, Color, Matrix, IndexList
    std::span<const EnumRow> choices;               ///< for Enum
    Value (*read)(const void* owner);               ///< `owner` is the struct whose table holds this row
    void (*write)(void* owner, const Value& value); ///< the value must hold the row's alternative
    std::size_t maxCount = 0;                       ///< of a list: its longest
};

struct StructTable;

/// A member that is a struct, a fixed array of structs or a list of structs.
struct ChildRow {
    MemberId member;
    std::string_view key;   ///< "textures"
    std::string_view label; ///< "Texture"
    const StructTable* table;
    bool indexed;         ///< "textures[0]" rather than "view"
    std::size_t minCount; ///< minCount == maxCount: a fixed array
    std::size_t maxCount;
    std::size_t (*size)(const void* owner);
    void* (*at)(void* owner, std::size_t index);
    /// New elements have their default values. A fixed array keeps its size: its elements from `count` on are
    /// reset.
    void (*resize)(void* owner, std::size_t count);
    bool (*isDefault)(const void* owner, std::size_t index); ///< whether the element equals a new one
};

struct StructTable {
    std::string_view name; ///< "Texture"
    std::span<const ParamRow> params;
    std::span<const ChildRow> children;
};

/// The root of the tables: Scene, with everything below it.
[[nodiscard]] const StructTable& sceneTable();
[[nodiscard]] const StructTable& viewTable();
[[nodiscard]] const StructTable& lightTable();
[[nodiscard]] const StructTable& projectorTable();
[[nodiscard]] const StructTable& materialTable();
[[nodiscard]] const StructTable& modelTable();
[[nodiscard]] const StructTable& modelMaterialTable(); ///< of one model: without what is the scene's
[[nodiscard]] const StructTable& meshTable();
[[nodiscard]] const StructTable& textureTable();
[[nodiscard]] const StructTable& givenLevelTable();
[[nodiscard]] const StructTable& imageStepTable();
[[nodiscard]] const StructTable& passTable();
[[nodiscard]] const StructTable& fogTable();
[[nodiscard]] const StructTable& unitTable();
[[nodiscard]] const StructTable& matrixStepTable();
[[nodiscard]] const StructTable& combineTable();
[[nodiscard]] const StructTable& embossTable();
[[nodiscard]] const StructTable& keyFrameTable();
/// For one of the coordinates s, t, r and q: 0 to 3. They differ in the modes that OpenGL accepts.
[[nodiscard]] const StructTable& texGenTable(std::size_t coordinate);

/// The longest Text that is accepted, in bytes.
inline constexpr std::size_t maxTextBytes = 4096;

/// The row with this key, or nullptr.
[[nodiscard]] const ParamRow* findParam(const StructTable& table, std::string_view key);
[[nodiscard]] const ChildRow* findChild(const StructTable& table, std::string_view key);
[[nodiscard]] std::vector<std::string_view> tableKeys(const StructTable& table);

/// What a row accepts, as the rest of a sentence: "a number from 1 to 16", "one of GL_NEAREST, GL_LINEAR".
[[nodiscard]] std::string describeAccepted(const ParamRow& row);

/// Whether a row accepts this value: the right alternative, within its range, finite, an enumerator that
/// exists. The error says what is accepted; its `where` is empty.
[[nodiscard]] Result<void> checkValue(const ParamRow& row, const Value& value);

/// A value as `--set` and `texshot params` write it: "GL_LINEAR", "0.5", "1,0,0,1", "true"; texture
/// coordinates and what else each vertex has are "0,0;1,0;1,1", one vertex after the other; whole numbers in
/// a list "0,2,1". parseValue reads it back exactly.
[[nodiscard]] std::string formatValue(const ParamRow& row, const Value& value);
[[nodiscard]] Result<Value> parseValue(const ParamRow& row, std::string_view text);

/// One vertex of a TexCoordList: "0.5,1", with r and q only where they aren't 0 and 1.
[[nodiscard]] std::string formatTexCoord(glm::vec4 coord);
[[nodiscard]] Result<glm::vec4> parseTexCoord(std::string_view text);

/// The row's GL call for a texture of this target: "glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, {})".
[[nodiscard]] std::string callFor(const ParamRow& row, Target target);

/// The same with the value in its place: "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {0, 0, 0, 1})",
/// "glDisable(GL_BLEND)"; empty where GL has no such state.
[[nodiscard]] std::string formatCall(const ParamRow& row, const Value& value,
                                     Target target = Target::Texture2D);

/// What OpenGL calls the parameter itself: "GL_TEXTURE_WRAP_S", "GL_LIGHTING"; the function where the value
/// is all that it takes, "glColor4f"; else empty.
[[nodiscard]] std::string_view glNameOf(const ParamRow& row);

/// Calls `visit` for every parameter of a scene in table order; `path` is "textures[0].minFilter".
void forEachParam(
    const Scene& scene,
    const std::function<void(const std::string& path, const ParamRow& row, const Value& value)>& visit);

/// A parameter of a scene.
struct ParamAt {
    const ParamRow* row;
    Value value;
};

/// The one at a path. Errors as of getParam, with which it has the path in common.
[[nodiscard]] Result<ParamAt> paramAt(const Scene& scene, std::string_view path);

/// The row alone, without a copy of the value.
[[nodiscard]] Result<const ParamRow*> rowAt(const Scene& scene, std::string_view path);

/// Reads or writes one parameter by its path, "passes[0].units[1].envMode". A list of texture coordinates can
/// be indexed: "models[0].texCoords0[5]" is a single coordinate of 2 to 4 numbers (an empty list is first
/// filled from the mesh). The error names the part of the path that does not exist and what would.
[[nodiscard]] Result<std::string> getParam(const Scene& scene, std::string_view path);
[[nodiscard]] Result<void> setParam(Scene& scene, std::string_view path, std::string_view text);

/// The same with what lies `share` (0 to 1) of the way from one value to the other (value_mix.h), and without
/// asking whether it fits what other parameters are: at a key frame several of them may change. Refused too:
/// a path into the timeline, which can't move itself.
[[nodiscard]] Result<void> putBetween(Scene& scene, std::string_view path, std::string_view from,
                                      std::string_view to, double share);
/// Whether it would take this value there.
[[nodiscard]] Result<void> checkMovable(const Scene& scene, std::string_view path, std::string_view text);

} // namespace texplorer
