#pragma once

#include "texplorer/emit/c_functions.h"
#include "texplorer/emit/code_writer.h"
#include "texplorer/emit/model_data.h"
#include "texplorer/emit/program.h"
#include "texplorer/emit/texel_code.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/texture_matrix.h"

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::emit {

/// A name that glGenTextures gives: OpenGL binds a texture object to one target for good.
struct TextureObject {
    std::size_t texture; ///< of the scene's
    Target target;

    bool operator==(const TextureObject&) const = default;
};

/// One object for each texture, in their order; then those that show one on another target, too.
[[nodiscard]] std::vector<TextureObject> textureObjectsOf(const Scene& scene, const KeyFrames& keys);

/// What OpenGL has when a frame begins and what it is left with may be two things, as each frame begins with
/// what the last one left. Where they differ nothing is known when a frame begins.
struct FrameStart {
    std::set<std::string, std::less<>> unknown{}; ///< of the writer's state
    std::array<std::optional<Target>, maxUnits>
        shown{}; ///< at the end of a frame, where it isn't so before it
    std::array<bool, maxUnits> mayShow{};
    std::array<bool, maxUnits> hasMatrix{};
    bool unitIsUnknown = false; ///< of glActiveTexture
};

/// What is on top of a unit's texture matrix stack.
struct StackTop {
    bool flips = false; ///< it begins with t -> 1 - t
    PlacedSteps steps{};

    bool operator==(const StackTop&) const = default;
};

/// What glPopMatrix will bring back.
struct PushedMatrix {
    std::size_t unit;
    std::optional<StackTop> top;
};

/// Why what the light sees doesn't move by key frames.
inline constexpr const char* computedLight = N_("the light's view is computed when the program is written");

/// Why a flavour can't say a parameter, in one sentence.
[[nodiscard]] inline tl::unexpected<Error> refuse(Sentence sentence, const std::string& path,
                                                  const std::string& key) {
    return fail(ErrorCode::Unsupported, std::move(sentence), path + '.' + key);
}

/// How one of s, t, r and q is generated.
struct GeneratedCoordinate {
    TexGen Unit::*state;
    Key key;
    std::string_view letter;
};
inline constexpr std::array<GeneratedCoordinate, 4> generatedCoordinates{{
    {&Unit::texGenS, keyOf<&Unit::texGenS>, "s"},
    {&Unit::texGenT, keyOf<&Unit::texGenT>, "t"},
    {&Unit::texGenR, keyOf<&Unit::texGenR>, "r"},
    {&Unit::texGenQ, keyOf<&Unit::texGenQ>, "q"},
}};

/// "passes[0].units[1]", and of what is in it: "passes[0].units[1].texGenS.mode".
[[nodiscard]] std::string unitPath(std::size_t pass, std::size_t unit,
                                   std::initializer_list<std::string_view> keys = {});

/// What is written, and what the parts of it have to know of each other.
struct Emission {
    Emission(Flavour flavour, const Scene& drawn, const ImageSource& images, const ProgramOptions& options,
             TextureCodes& codes, KeyFrames& keys);

    const Scene& scene;
    const ProgramOptions& options;
    KeyFrames& keys; ///< what moves of the scene
    CodeWriter writer;
    CodeWriter atEnd; ///< arrays of many numbers, of which the beginning has the names alone
    CodeWriter atStart;
    std::set<CFunction> functions;
    std::vector<TextureObject> objects;
    std::vector<std::shared_ptr<const Result<TextureCode>>> texels; ///< of each object
    std::vector<ModelForm> models;                                  ///< how each is drawn
    std::vector<std::array<LateFlip, maxUnits>> lateFlips;          ///< of each pass's units
    bool isCore;                         ///< OpenGL 3.3 without what it took from OpenGL 2.1
    bool isLit;                          ///< some pass is
    bool needsNormals = false;           ///< some pass is lit or reflects
    bool hasLightExtent = false;         ///< a constant of the program
    bool callsGlu = false;               ///< for shapes or levels: then for the projection, too
    std::set<std::size_t> leftOut{};     ///< of the objects: nothing shows them
    std::set<std::size_t> transferred{}; ///< of the objects: glPixelTransferf scales what is uploaded
    bool moves = false;                  ///< draw() is given the seconds since the start
    bool inFrame = false;                ///< what is written is done in every frame, after the camera's calls

    int activeUnit = 0;
    std::array<std::optional<Target>, maxUnits> shown{};
    std::array<bool, maxUnits> mayShow{}; ///< or not
    /// Of the texture matrices; nothing where it isn't known.
    std::array<std::optional<StackTop>, maxUnits> stacks{StackTop{}, StackTop{}, StackTop{}, StackTop{}};
    std::vector<PushedMatrix> pushedByPass{};
    std::vector<PushedMatrix> pushedByModel{};
    std::array<bool, maxUnits> isFresh{}; ///< the matrix has been set since the last model was drawn
    bool hasPopped = false;               ///< a matrix since the last model was drawn

    /// What variables of a pass begin with; nothing where there is only one.
    [[nodiscard]] std::string passVariable(std::size_t pass) const;
    /// The texture object that a unit shows, or nullptr.
    [[nodiscard]] const TextureCode* codeOf(const Unit& unit) const;
    /// Whether t of a model's coordinates for a unit is turned around.
    [[nodiscard]] bool flipsCoords(std::size_t model, std::size_t unit) const;
    /// What has many numbers: its name at the start, the numbers at the end of the program.
    void addData(const std::string& type, const std::string& name, std::size_t count, Numbers numbers);
    void use(CFunction function) { addWithCallees(functions, function); }

private:
    /// Refuses what decides which vertices models have and which numbers a vertex has.
    void refuseShapes();
};

// The program of a scene as it stands; what moves of it by key frames does so as `keys` say, which afterwards
// know what of them it couldn't say.
[[nodiscard]] Result<std::vector<Line>> fixedProgram(const Scene& scene, const ImageSource& images,
                                                     const ProgramOptions& options, TextureCodes& codes,
                                                     KeyFrames& keys);
[[nodiscard]] Result<std::vector<Line>> glslProgram(const Scene& scene, const ImageSource& images,
                                                    const ProgramOptions& options, TextureCodes& codes,
                                                    KeyFrames& keys);

/// Keys, what they say at a time, and the variables that hold it: before everything that is done in a frame.
void writeKeyFrames(Emission& emission);
/// At the start of a frame: the variables are what the keys say then.
void writeKeyFramesCall(Emission& emission);

/// Paths of a texture's parameters; of those that say whether an average reads the border.
[[nodiscard]] std::vector<std::string> texturePaths(std::size_t texture,
                                                    std::initializer_list<std::string> keys);
[[nodiscard]] std::vector<std::string> samplerPaths(std::size_t texture);
/// Then GL_CLAMP and GL_CLAMP_TO_EDGE are one: only averages ask for the border.
[[nodiscard]] bool readsNearestAlone(const Texture& texture);
/// The functions that load the textures.
void writeTextures(Emission& emission);
/// What moves of them, in every frame before what shows them.
void writeMovingTextures(Emission& emission);
void writeTexels(Emission& emission, const Holder& holder, std::size_t object);
// Calls before an upload and, if it is over, after it, with OpenGL's initial values.
/// glPixelTransferf: what a step says of all levels.
void writeTransfer(CodeWriter& writer, const ImageStep& step, const std::string& path, bool isOver);
/// glPixelStorei and glPixelTransferf of a custom upload.
void writeUnpacking(CodeWriter& writer, const Upload& upload, const std::string& path, bool isOver);
/// The array of what a custom upload reads, of all faces; the expression for where it is read.
[[nodiscard]] std::string writeMemory(Emission& emission, const std::shared_ptr<const LevelCode>& level,
                                      const Upload& upload, const std::string& name);
/// glClear, and the projection for a picture of `width` times `height`.
void writeProjection(Emission& emission);
/// Both of programs that make their matrices themselves: the projection and the view.
void writeMatrices(Emission& emission, bool draws);
void writeLight(Emission& emission);
/// What moves of it, in every frame.
void writeMovingLight(Emission& emission);
/// The camera's calls, on the matrix that there is; before them the variables that the mouse changes.
void writeCamera(Emission& emission);
void declareCamera(Emission& emission);
/// The variable of what the mouse changes, with what key frames say of it.
[[nodiscard]] std::string cameraVariable(Emission& emission, MemberId member);
/// What the matrices of the light are computed of.
[[nodiscard]] std::vector<std::string> lightPaths();
/// What multiplies by the projection of what the light sees, and by its view of eye coordinates, whose
/// array's name begins with `variable`.
void writeLightProjection(Emission& emission);
void writeLightView(Emission& emission, const std::string& variable);
/// The function that draws what the light sees, for the textures that show it; its call in a frame.
void writeShadowMaps(Emission& emission);
void writeShadowMapCalls(Emission& emission);
/// Whether an object holds what the light sees and some pass shows it.
[[nodiscard]] bool isShadowMap(const Emission& emission, std::size_t object);
/// The models that the light sees, and whether any of them turns with the time.
[[nodiscard]] std::vector<std::size_t> modelsInLight(const Scene& scene);
[[nodiscard]] bool spinsInLight(const Emission& emission);
/// Where a program would have too many vertices in it.
[[nodiscard]] Result<void> checkMeshes(const Scene& scene);
/// Where a program can't draw what the light sees: why.
[[nodiscard]] Result<void> checkShadowMaps(const Scene& scene, const KeyFrames& keys);
/// The objects that show pictures of passes, in the order in which those are drawn, and the passes of each.
[[nodiscard]] std::vector<std::size_t> picturesOf(const Emission& emission);
[[nodiscard]] std::vector<std::size_t> passesOf(const Emission& emission, std::size_t object);
/// Where a program can't draw such a picture: why.
[[nodiscard]] Result<void> checkPictures(const Scene& scene, const KeyFrames& keys);
/// Room for a picture.
void writePictureRoom(Emission& emission, std::size_t object);
/// A function that draws a picture, but for its passes: its head and its end. The first returns how often the
/// seconds were used before it.
[[nodiscard]] int beginPicture(Emission& emission, std::size_t object);
void endPicture(Emission& emission, std::size_t object, int secondsUses);
/// Its calls in a frame.
void writePictureCalls(Emission& emission);
/// The scene's: all of it.
void writeMaterial(Emission& emission);
/// How all of them are shaded, where that moves.
void writeMovingShadeModel(Emission& emission);
/// A model's: what differs from the one that was written before.
void writeMaterial(Emission& emission, std::size_t model);
void writeUnits(Emission& emission, std::size_t pass);
/// "glBindTexture(GL_TEXTURE_2D, textures[0]);" of a unit that is on; empty: there is no such texture.
[[nodiscard]] std::vector<Part> bindingCall(Emission& emission, const Unit& unit,
                                            const std::string& unitPath);
/// "passes[0].units[1].matrix[2]"
[[nodiscard]] std::string stepPath(const PlacedStep& placed, std::size_t unit);
/// Whether any of a unit's steps changes with the time.
[[nodiscard]] bool anyMoves(const Emission& emission, const PlacedSteps& steps, std::size_t unit);
/// The calls for the texture matrix stacks: when a pass begins, around each model, and after the pass.
void writePassMatrix(Emission& emission, std::size_t pass, std::size_t unit, const std::string& variable);
void writeModelMatrices(Emission& emission, std::size_t pass, std::size_t model);
void endModelMatrices(Emission& emission);
void endPassMatrices(Emission& emission);
/// What moves of units, in every frame where nothing else of them is set.
void writeMovingUnits(Emission& emission, std::size_t pass);
/// "sphere(32, 16)": what makes a Mesh of a shape that is turned about an axis.
[[nodiscard]] std::vector<Part> shapeCall(Emission& emission, std::size_t model);
/// Lets GLU draw what it can of the models, and the projection where it is called anyway.
void takeGlu(Emission& emission);
[[nodiscard]] bool hasQuadrics(const Emission& emission);
/// Whether the axis of a quadric is y: that of GLU's is z.
[[nodiscard]] bool isTurnedForGlu(const Model& model);
/// "gluSphere(quadric, 1.0, 32, 16);"
void writeQuadric(Emission& emission, std::size_t model);
/// Arrays and functions of a model, before everything that draws.
void writeModelData(Emission& emission, std::size_t model);
/// What is made of them once.
void writeModelSetup(Emission& emission, std::size_t model);
void writeModel(Emission& emission, std::size_t pass, std::size_t model);
/// Its surface alone, on the matrix that there is.
void writeModelShape(Emission& emission, std::size_t model);
/// Compiles a display list of it.
void writeList(Emission& emission, std::size_t model);
/// What glBegin is given.
[[nodiscard]] Part primitivePart(const Model& model, std::size_t index);

} // namespace texplorer::emit
