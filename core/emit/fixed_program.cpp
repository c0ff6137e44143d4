// OpenGL 2.1 and C99.

#include "texplorer/emit/emission.h"
#include "texplorer/emit/program_frame.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/pass_pictures.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// Of fog, only what its mode looks at, which may be each of them in turn.
bool hasEffect(const ParamRow& row, const Fog& fog, bool modeMoves) {
    if (row.member == memberId<&Fog::enabled>)
        return true;
    const bool isLinear = fog.mode == FogMode::Linear;
    if (row.member == memberId<&Fog::density>)
        return fog.enabled && (modeMoves || !isLinear);
    if (row.member == memberId<&Fog::start> || row.member == memberId<&Fog::end>)
        return fog.enabled && (modeMoves || isLinear);
    return fog.enabled;
}

/// A driver of OpenGL 2.1 doesn't know the name.
bool hasCubeMap(const Pass& pass) {
    return std::ranges::any_of(
        pass.units, [](const Unit& unit) { return unit.enabled && unit.target == Target::CubeMap; });
}

void writePassState(Emission& emission, std::size_t index) {
    static const Pass initial;
    const Pass& pass = emission.scene.passes[index];
    const std::string path = elementOf<&Scene::passes>(index);
    CodeWriter& writer = emission.writer;
    if (emission.passVariable(index).empty())
        writer.heading("lighting, tests, blending and fog");
    else if (pass.name.empty())
        writer.heading(fmt::format("pass {}", index));
    else
        writer.heading(fmt::format("pass {}: {}", index, pass.name));
    const Holder holder{passTable(), &pass, &initial, path, "pass", emission.passVariable(index)};
    for (const ParamRow& row : holder.table.params) {
        const bool isUnknown = row.member == memberId<&Pass::seamlessCubeMap> && !hasCubeMap(pass);
        if (!row.glCall.empty() && !isUnknown)
            writer.row(holder, row);
    }
    const std::string& fog = keyOf<&Pass::fog>();
    const Holder fogHolder{fogTable(),   &pass.fog,
                           &initial.fog, fmt::format("{}.{}", path, fog),
                           fog,          joined(holder.variable, fog)};
    const bool modeMoves = writer.moves(fmt::format("{}.{}", fogHolder.path, keyOf<&Fog::mode>()));
    for (const ParamRow& row : fogHolder.table.params) {
        if (hasEffect(row, pass.fog, modeMoves))
            writer.row(fogHolder, row);
    }
}

/// The passes that draw something in the window.
std::vector<std::size_t> drawnPasses(const Scene& scene) {
    std::vector<std::size_t> passes;
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        if (scene.passes[p].picture == 0 && drawsAnything(scene, scene.passes[p]))
            passes.push_back(p);
    }
    return passes;
}

/// init(), and draw() with what each frame does.
class FixedWriter {
public:
    FixedWriter(Emission& emission, const FrameStart& start)
        : emission_(emission)
        , writer_(emission.writer)
        , start_(start)
        , passes_(drawnPasses(emission.scene))
        , pictures_(picturesOf(emission)) {}

    void write() {
        writeTextures(emission_);
        for (std::size_t m = 0; m < emission_.scene.models.size(); ++m)
            writeModelData(emission_, m);
        declareCamera(emission_);
        writeInit();
        writer_.take(Taking::All);
        writeKeyFrames(emission_);
        writeShadowMaps(emission_);
        beginFrame();
        for (const std::size_t object : pictures_)
            writePicture(object);
        writeDraw();
    }

    /// What the second frame begins with otherwise than the first.
    [[nodiscard]] FrameStart end() const {
        FrameStart found;
        for (const auto& [key, value] : writer_.state()) {
            const auto before = before_.find(key);
            const auto initial = writer_.initialState().find(key);
            const bool wasKnown = before != before_.end();
            if (wasKnown ? before->second != value
                         : initial == writer_.initialState().end() || initial->second != value)
                found.unknown.insert(key);
        }
        for (std::size_t i = 0; i < maxUnits; ++i) {
            found.mayShow[i] = emission_.shown[i] != shownBefore_[i];
            found.shown[i] = emission_.shown[i] ? emission_.shown[i] : shownBefore_[i];
            found.hasMatrix[i] = emission_.stacks[i] != StackTop{};
        }
        found.unitIsUnknown = emission_.activeUnit != unitBefore_;
        return found;
    }

private:
    /// Whether the state of a pass is set once.
    [[nodiscard]] bool isOne() const { return passes_.size() == 1 && pictures_.empty(); }

    void writePass(std::size_t pass) {
        writePassState(emission_, pass);
        writeUnits(emission_, pass);
    }

    /// What moves of the only pass.
    void writeMovingPass(std::size_t pass) {
        const std::size_t start = writer_.size();
        writer_.take(Taking::Moving);
        writePassState(emission_, pass);
        writer_.take(Taking::All);
        if (writer_.size() == start + 1) // its heading
            writer_.truncate(start);
        writeMovingUnits(emission_, pass);
    }

    void writeInit() {
        writer_.heading("what is set once");
        writer_.open("static void init(void)");
        writer_.heading(keyOf<&Scene::textures>());
        if (!emission_.objects.empty()) {
            writer_.add(fmt::format("glGenTextures({}, textures);", emission_.objects.size()));
            writer_.add({call("glPixelStorei"),
                         plain("(GL_UNPACK_ALIGNMENT, 1); "),
                         {Part::Kind::Comment, "/* rows of texels follow each other without a gap */"}});
            for (std::size_t i = 0; i < emission_.objects.size(); ++i)
                writer_.add(fmt::format("loadTexture{}();", i));
        }
        writer_.heading(keyOf<&Scene::models>());
        if (hasQuadrics(emission_)) {
            emission_.atStart.add({plain("static GLUquadric *quadric; "),
                                   {Part::Kind::Comment, "/* GLU's state for drawing shapes */"}});
            writer_.add("quadric = gluNewQuadric();");
            writer_.add({call("gluQuadricTexture"),
                         plain("(quadric, GL_TRUE); "),
                         {Part::Kind::Comment, "/* generates texture coordinates */"}});
        }
        for (std::size_t m = 0; m < emission_.scene.models.size(); ++m)
            writeModelSetup(emission_, m);
        writeLight(emission_);
        writeMaterial(emission_);
        if (isOne())
            writePass(passes_.front());
        writer_.close();
    }

    void beginFrame() {
        for (const std::string& key : start_.unknown)
            writer_.forget(key);
        before_ = writer_.state();
        shownBefore_ = emission_.shown;
        unitBefore_ = emission_.activeUnit;
        for (std::size_t i = 0; i < maxUnits; ++i) {
            if (start_.mayShow[i])
                emission_.shown[i] = start_.shown[i];
            emission_.mayShow[i] = start_.mayShow[i];
            if (start_.hasMatrix[i])
                emission_.stacks[i].reset();
        }
        if (start_.unitIsUnknown)
            emission_.activeUnit = -1;
        emission_.inFrame = true;
    }

    void writeDraw() {
        writer_.heading("a frame");
        writer_.open(emission_.moves ? "static void draw(int width, int height, double seconds)"
                                     : "static void draw(int width, int height)");
        writeKeyFramesCall(emission_);
        writeShadowMapCalls(emission_);
        writePictureCalls(emission_);
        writePasses(passes_);
        writer_.close();
    }

    /// What a picture of passes shows.
    void writePicture(std::size_t object) {
        const int secondsUses = beginPicture(emission_, object);
        if (shownFrames(emission_.scene) > 1 || !unfinishedReads(emission_.scene).empty()) {
            forgetFrame();
            writeKeyFramesCall(emission_);
        }
        writePasses(passesOf(emission_, object));
        endPicture(emission_, object, secondsUses);
    }

    /// It is drawn several times in a frame, or after other calls: nothing is known when it begins.
    void forgetFrame() {
        for (const auto& [key, value] : CodeWriter::State(writer_.state()))
            writer_.forget(key);
        emission_.mayShow.fill(true);
        for (std::optional<StackTop>& stack : emission_.stacks)
            stack.reset();
        emission_.activeUnit = -1;
    }

    void writePasses(const std::vector<std::size_t>& passes) {
        writeProjection(emission_);
        writeMovingLight(emission_);
        writeMovingShadeModel(emission_);
        writeMovingTextures(emission_);
        writer_.heading("camera");
        writer_.add("glLoadIdentity();");
        writeCamera(emission_);
        for (const std::size_t pass : passes) {
            if (isOne())
                writeMovingPass(pass);
            else
                writePass(pass);
            for (const std::size_t model : drawnModels(emission_.scene, emission_.scene.passes[pass]))
                writeModel(emission_, pass, model);
            endPassMatrices(emission_);
        }
    }

    Emission& emission_;
    CodeWriter& writer_;
    const FrameStart& start_;
    std::vector<std::size_t> passes_;
    std::vector<std::size_t> pictures_; ///< texture objects that show what other passes draw
    CodeWriter::State before_;
    std::array<std::optional<Target>, maxUnits> shownBefore_{};
    int unitBefore_ = 0;
};

} // namespace

Result<std::vector<Line>> fixedProgram(const Scene& scene, const ImageSource& images,
                                       const ProgramOptions& options, TextureCodes& codes, KeyFrames& keys) {
    if (const Result<void> possible = checkMeshes(scene); !possible)
        return fail(possible.error());
    if (const Result<void> possible = checkShadowMaps(scene, keys); !possible)
        return fail(possible.error());
    if (const Result<void> possible = checkPictures(scene, keys); !possible)
        return fail(possible.error());
    FrameStart start;
    bool moves = false;
    { // once to see what a frame leaves behind, and whether anything moves
        Emission trial(Flavour::Fixed, scene, images, options, codes, keys);
        FixedWriter writer(trial, start);
        writer.write();
        start = writer.end();
        moves = trial.writer.usesSeconds() || keys.isUsed();
    }
    Emission emission(Flavour::Fixed, scene, images, options, codes, keys);
    emission.moves = moves;
    FixedWriter(emission, start).write();
    return framed(std::move(emission), {});
}

} // namespace texplorer::emit
