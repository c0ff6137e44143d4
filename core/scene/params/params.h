#pragma once

// One row per editable parameter. Its key, label, help and GL call are written nowhere else; panels, JSON,
// `--set`, `texshot params` and the command view are made from these tables.

#include "texplorer/base/result.h"
#include "texplorer/gl/enum_row.h"
#include "texplorer/scene/scene.h"

#include <functional>
#include <variant>

namespace texplorer {

/// An enumerator without its type; `choices` of its row lists the possible values.
struct EnumValue {
    std::uint32_t number;
    bool operator==(const EnumValue&) const = default;
};

using Value = std::variant<bool, int, float, glm::vec3, glm::vec4, glm::mat4, EnumValue, std::string,
                           SharedList<glm::vec3>, SharedList<glm::vec4>, SharedList<int>>;

/// The elements of the lists are 3, 3 to 4, or 2 to 4 numbers for each vertex; or whole numbers.
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

/// The accepted numbers of each component, limits included; `step` is the change for a drag of one pixel.
struct Range {
    float min = 0;
    float max = 1;
    float step = 0.01F;
    std::string_view unit = {}; ///< "deg", "deg/s", "texels"; empty for a plain number
    /// The meaning of the initial value, if the number does not show it: "no limit"
    std::string_view initially = {};
};

/// Identifies a member of any struct: `memberId<&Texture::minFilter>`.
using MemberId = const char*;
template<auto Member>
inline constexpr char memberMark = 0;
template<auto Member>
inline constexpr MemberId memberId = &memberMark<Member>;

struct ParamRow {
    MemberId member;
    std::string_view key;   ///< the JSON key and the last part of its path: "minFilter"
    std::string_view group; ///< its section of the panel: "Filter"
    std::string_view label; ///< "Minification"
    std::string_view help;  ///< one or two sentences for students
    /// The call that sets it, with "{}" for the value; empty if GL has no such state. A call without "{}" is
    /// a glEnable, reversed by glDisable. Names that are not GL's are other keys of the same struct:
    /// "glAlphaFunc({}, alphaRef)". Words in braces such as "{target}" depend on the texture's target
    /// (gl_call.cpp).
    std::string_view glCall;
    Kind kind;
    Range range;                                    ///< for Int, Float, Vec3, Vec4, Color, Matrix, IndexList
    std::span<const EnumRow> choices;               ///< for Enum
    Value (*read)(const void* owner);               ///< `owner` is the struct of the table
    void (*write)(void* owner, const Value& value); ///< the value must hold the type of the row
    std::size_t maxCount = 0;                       ///< the maximum length of a list
};

struct StructTable;

/// A member that is a struct, a fixed array of structs or a list of structs.
struct ChildRow {
    MemberId member;
    std::string_view key;   ///< "textures"
    std::string_view label; ///< "Texture"
    const StructTable* table;
    bool indexed;         ///< "textures[0]" instead of "view"
    std::size_t minCount; ///< minCount == maxCount: a fixed array
    std::size_t maxCount;
    std::size_t (*size)(const void* owner);
    void* (*at)(void* owner, std::size_t index);
    /// New elements have their default values. A fixed array keeps its size: elements from `count` on are
    /// reset.
    void (*resize)(void* owner, std::size_t count);
    bool (*isDefault)(const void* owner, std::size_t index); ///< the element equals a new one

    // For lists, whose length varies; nullptr for others.
    void (*insert)(void* owner, std::size_t index,
                   const void* like) = nullptr; ///< a copy; nullptr: a new one
    void (*erase)(void* owner, std::size_t index) = nullptr;
    void (*move)(void* owner, std::size_t from, std::size_t to) = nullptr;
};

struct StructTable {
    std::string_view name; ///< "Texture"
    std::span<const ParamRow> params;
    std::span<const ChildRow> children;
};

/// The root of the tables: Scene and everything in it.
[[nodiscard]] const StructTable& sceneTable();
[[nodiscard]] const StructTable& viewTable();
[[nodiscard]] const StructTable& lightTable();
[[nodiscard]] const StructTable& projectorTable();
[[nodiscard]] const StructTable& materialTable();
[[nodiscard]] const StructTable& modelTable();
[[nodiscard]] const StructTable&
modelMaterialTable(); ///< of one model: without the members that only the scene's has
[[nodiscard]] const StructTable& meshTable();
[[nodiscard]] const StructTable& modelUnitTable();
[[nodiscard]] const StructTable& textureTable();
[[nodiscard]] const StructTable& givenLevelTable();
[[nodiscard]] const StructTable& imageStepTable();
[[nodiscard]] const StructTable& subimageTable();
[[nodiscard]] const StructTable& passTable();
[[nodiscard]] const StructTable& fogTable();
[[nodiscard]] const StructTable& unitTable();
[[nodiscard]] const StructTable& matrixStepTable();
[[nodiscard]] const StructTable& combineTable();
[[nodiscard]] const StructTable& embossTable();
[[nodiscard]] const StructTable& uploadTable();
[[nodiscard]] const StructTable& keyFrameTable();
/// For the coordinates s, t, r and q: 0 to 3. They differ in the accepted modes.
[[nodiscard]] const StructTable& texGenTable(std::size_t coordinate);

/// The maximum length of a Text, in bytes.
inline constexpr std::size_t maxTextBytes = 4096;

/// The row with this key, or nullptr.
[[nodiscard]] const ParamRow* findParam(const StructTable& table, std::string_view key);
[[nodiscard]] const ChildRow* findChild(const StructTable& table, std::string_view key);
[[nodiscard]] std::vector<std::string_view> tableKeys(const StructTable& table);

/// The accepted values of a row, as the end of a sentence: "a number from 1 to 16", "one of GL_NEAREST,
/// GL_LINEAR".
[[nodiscard]] Sentence describeAccepted(const ParamRow& row);

/// Checks a value: its type, its range, finite, an existing enumerator. The error says what is accepted; its
/// `where` is empty.
[[nodiscard]] Result<void> checkValue(const ParamRow& row, const Value& value);

/// Formats a value for `--set` and `texshot params`: "GL_LINEAR", "0.5", "1,0,0,1", "true"; texture
/// coordinates and other per-vertex lists as "0,0;1,0;1,1", vertex by vertex; lists of whole numbers as
/// "0,2,1". parseValue restores it exactly.
[[nodiscard]] std::string formatValue(const ParamRow& row, const Value& value);
[[nodiscard]] Result<Value> parseValue(const ParamRow& row, std::string_view text);

/// One vertex of a TexCoordList: "0.5,1", with r and q only if they are not 0 and 1.
[[nodiscard]] std::string formatTexCoord(glm::vec4 coord);
[[nodiscard]] Result<glm::vec4> parseTexCoord(std::string_view text);

/// The row's GL call for a texture of this target: "glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, {})".
[[nodiscard]] std::string callFor(const ParamRow& row, Target target);

/// The same with the value: "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {0, 0, 0, 1})",
/// "glDisable(GL_BLEND)"; empty if GL has no such state.
[[nodiscard]] std::string formatCall(const ParamRow& row, const Value& value,
                                     Target target = Target::Texture2D);

/// OpenGL's name of the parameter: "GL_TEXTURE_WRAP_S", "GL_LIGHTING"; the function if the value is its only
/// argument, "glColor4f"; else empty.
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

/// Returns the parameter at a path. Errors as of getParam.
[[nodiscard]] Result<ParamAt> paramAt(const Scene& scene, std::string_view path);

/// The same, without a copy of the value.
[[nodiscard]] Result<const ParamRow*> rowAt(const Scene& scene, std::string_view path);

/// A list or a fixed array of structs in a scene.
struct ListAt {
    const ChildRow* row;
    void* owner;

    [[nodiscard]] std::size_t size() const { return row->size(owner); }
};

/// Returns the list at a path, "textures" or "passes[0].units". Errors as of getParam.
[[nodiscard]] Result<ListAt> listAt(Scene& scene, std::string_view path);

/// Whether a path may name one element of a row's list: texture coordinates and the lists of a mesh.
[[nodiscard]] bool hasElements(const ParamRow& row);

/// Gets or sets one parameter by its path, "passes[0].units[1].envMode". A list of texture coordinates can be
/// indexed: "models[0].texCoords0[5]" is a single coordinate of 2 to 4 numbers (an empty list is first filled
/// from the mesh). So can the lists of a mesh, "models[0].mesh.positions[5]", for the elements that they
/// have. The error names the part of the path that does not exist, and what does. A path that is set may have
/// `newElement` for an index, "textures[0].preparation[+].op": it appends an element to the list.
inline constexpr std::string_view newElement = "[+]";
[[nodiscard]] Result<std::string> getParam(const Scene& scene, std::string_view path);
[[nodiscard]] Result<void> setParam(Scene& scene, std::string_view path, std::string_view text);

/// Sets a value interpolated between two others, at `share` from 0 to 1 (value_mix.h). Does not check that it
/// fits the other parameters: at a key frame, several of them can change. Also an error: a path in the
/// timeline, which cannot be animated.
[[nodiscard]] Result<void> putBetween(Scene& scene, std::string_view path, std::string_view from,
                                      std::string_view to, double share);
/// Checks whether a parameter accepts this value in a key frame.
[[nodiscard]] Result<void> checkMovable(const Scene& scene, std::string_view path, std::string_view text);

} // namespace texplorer
