#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// The three numbers of a vector that changes with time, "1.0f, 0.0f + 0.5f * seconds, 0.0f".
std::vector<Part> movingNumbers(CodeWriter& writer, const glm::vec3& start, const glm::vec3& rate,
                                const std::string& startPath, const std::string& ratePath) {
    std::vector<Part> parts;
    const bool moves = writer.moves(ratePath);
    for (int i = 0; i < 3; ++i) {
        if (i > 0)
            parts.push_back(plain(", "));
        append(parts, moving(writer, number(start[i], startPath, i), number(rate[i], ratePath, i),
                             moves || rate[i] != 0));
    }
    return parts;
}

/// The calls of one step of a texture matrix.
class StepWriter {
public:
    StepWriter(Emission& emission, const Holder& unit, std::size_t index)
        : emission_(emission)
        , writer_(emission.writer)
        , step_(static_cast<const Unit*>(unit.values)->matrix[index])
        , path_(fmt::format("{}.{}", unit.path, elementOf<&Unit::matrix>(index)))
        , variable_(fmt::format("{}Matrix{}", unit.variable, index)) {}

    void write() {
        const bool pivots = (step_.op == MatrixOp::Rotate || step_.op == MatrixOp::Scale) &&
                            (step_.pivot != glm::vec3(0) || writer_.moves(own(keyOf<&MatrixStep::pivot>())));
        if (pivots)
            move(false);
        const std::string angle = own(keyOf<&MatrixStep::angle>());
        switch (step_.op) {
        case MatrixOp::Translate:
            writer_.add(callWith("glTranslatef", amount()));
            break;
        case MatrixOp::Rotate: {
            if (step_.rate == glm::vec3(0) && step_.amount == glm::vec3(0) &&
                !writer_.moves(own(keyOf<&MatrixStep::rate>())) &&
                !writer_.moves(own(keyOf<&MatrixStep::amount>())))
                break; // no axis: OpenGL leaves it undefined
            const std::string rate = own(keyOf<&MatrixStep::angleRate>());
            std::vector<Part> arguments =
                turning(writer_, number(step_.angle, angle), number(step_.angleRate, rate),
                        step_.angleRate != 0 || writer_.moves(rate));
            arguments.push_back(plain(", "));
            append(arguments, amount());
            writer_.add(callWith("glRotatef", std::move(arguments)),
                        step_.angle != 0 || step_.angleRate != 0);
            break;
        }
        case MatrixOp::Scale:
            writer_.add(callWith("glScalef", amount()));
            break;
        case MatrixOp::Multiply:
            matrix("glMultMatrixf", step_.matrix, own(keyOf<&MatrixStep::matrix>()));
            break;
        case MatrixOp::Load:
            matrix("glLoadMatrixf", step_.matrix, own(keyOf<&MatrixStep::matrix>()));
            break;
        case MatrixOp::Projector:
            lightView();
            break;
        }
        if (pivots)
            move(true);
    }

private:
    [[nodiscard]] std::string own(std::string_view key) const { return fmt::format("{}.{}", path_, key); }

    [[nodiscard]] std::vector<Part> amount() const {
        return movingNumbers(writer_, step_.amount, step_.rate, own(keyOf<&MatrixStep::amount>()),
                             own(keyOf<&MatrixStep::rate>()));
    }

    void move(bool back) {
        writer_.add(callWith("glTranslatef", numbers({&step_.pivot.x, 3}, own(keyOf<&MatrixStep::pivot>()),
                                                     Literal::Float, back)));
    }

    void matrix(std::string_view name, const glm::mat4& values, const std::string& path) {
        const bool moves = writer_.moves(path); // then a variable has all of it
        if (!moves)
            writer_.floats(variable_, numbers({glm::value_ptr(values), 16}, path));
        writer_.add({call(name),
                     plain("("),
                     {Part::Kind::Plain, variable_, moves ? path : std::string()},
                     plain(");")});
    }

    /// From eye coordinates to the light's picture: as a camera in its place would be set up, and then from
    /// -1 to 1 to 0 to 1.
    void lightView() {
        writer_.add("glTranslatef(0.5f, 0.5f, 0.5f);");
        writer_.add("glScalef(0.5f, 0.5f, 0.5f);");
        writeLightProjection(emission_);
        writeLightView(emission_, variable_);
    }

    Emission& emission_;
    CodeWriter& writer_;
    const MatrixStep& step_;
    std::string path_;
    std::string variable_;
};

/// Whether the matrix of some unit that is on does.
bool movesSomeMatrix(const Emission& emission, std::size_t pass) {
    for (std::size_t i = 0; i < maxUnits; ++i) {
        if (emission.scene.passes[pass].units[i].enabled && movesMatrix(emission, pass, i))
            return true;
    }
    return false;
}

class UnitWriter {
public:
    UnitWriter(Emission& emission, std::size_t pass, std::size_t index)
        : emission_(emission)
        , writer_(emission.writer)
        , unit_(emission.scene.passes[pass].units[index])
        , movesSomeMatrix_(movesSomeMatrix(emission, pass))
        , pass_(pass)
        , index_(index)
        , holder_{unitTable(),
                  &unit_,
                  &initialUnit(),
                  unitPath(pass, index),
                  elementOf<&Pass::units>(index),
                  joined(emission.passVariable(pass), fmt::format("unit{}", index)),
                  unit_.target} {}

    /// In every frame, where nothing else of the unit is.
    void writeMoving() {
        if (!unit_.enabled)
            return;
        const std::size_t start = writer_.size();
        writer_.heading(fmt::format("unit {}", index_));
        activate(emission_.activeUnit != static_cast<int>(index_));
        const std::size_t size = writer_.size();
        writer_.take(Taking::Moving);
        if (const std::vector<Part> parts = switching(true, unit_.target); writer_.takes(parts))
            writer_.add(parts);
        bind();
        writeRows();
        writer_.take(Taking::All);
        if (movesSomeMatrix_)
            writeMatrix();
        if (writer_.size() == size)
            writer_.truncate(start);
        else
            emission_.activeUnit = static_cast<int>(index_);
    }

    void write() {
        writer_.heading(fmt::format("unit {}", index_));
        if (unit_.enabled)
            writeOn();
        else
            writeOff();
    }

private:
    static const Unit& initialUnit() {
        static const Unit initial;
        return initial;
    }

    void activate(bool needed) {
        writer_.add({call("glActiveTexture"), plain(fmt::format("({});", textureUnitName(index_)))}, needed);
    }

    [[nodiscard]] std::string own(std::string_view key) const {
        return fmt::format("{}.{}", holder_.path, key);
    }

    /// glEnable or glDisable of a target, which is the unit's but where the pass before had another.
    [[nodiscard]] std::vector<Part> switching(bool on, Target target) const {
        const std::string_view name = rowOf(target).name;
        return {enabling(on, own(keyOf<&Unit::enabled>())), plain("("),
                target == unit_.target ? choice(name, own(keyOf<&Unit::target>())) : plain(std::string(name)),
                plain(");")};
    }

    void writeOff() {
        std::optional<Target>& shown = emission_.shown[index_];
        const bool wasOn = shown.has_value();
        activate(wasOn);
        writer_.add(switching(false, shown.value_or(unit_.target)), wasOn);
        shown.reset();
        emission_.mayShow[index_] = false;
        if (wasOn)
            emission_.activeUnit = static_cast<int>(index_);
    }

    void writeOn() {
        activate(emission_.activeUnit != static_cast<int>(index_));
        emission_.activeUnit = static_cast<int>(index_);
        std::optional<Target>& shown = emission_.shown[index_];
        if (shown && *shown != unit_.target)
            writer_.add({enabling(false, {}), plain(fmt::format("({});", rowOf(*shown).name))});
        if (const std::vector<Part> parts = switching(true, unit_.target); writer_.takes(parts))
            writer_.add(parts, shown != unit_.target || emission_.mayShow[index_]);
        shown = unit_.target;
        emission_.mayShow[index_] = writer_.moves(own(keyOf<&Unit::enabled>()));
        bind();
        writeRows();
        const bool isLeftToTheFrame = !emission_.inFrame && movesSomeMatrix_;
        if (!isLeftToTheFrame)
            writeMatrix();
    }

    /// The environment and the generation of coordinates.
    void writeRows() {
        const std::array taken{memberId<&Unit::enabled>, memberId<&Unit::target>, memberId<&Unit::texture>};
        for (const ParamRow& row : holder_.table.params) {
            if (std::ranges::find(taken, row.member) == taken.end())
                writer_.row(holder_, row);
        }
        if (emission_.keys.mayBe(own(keyOf<&Unit::envMode>()), unit_.envMode,
                                 [](EnvMode mode) { return mode == EnvMode::Combine; })) {
            const Holder combine = part(combineTable(), &unit_.combine, &initialUnit().combine,
                                        keyOf<&Unit::combine>(), keyOf<&Unit::combine>());
            for (const ParamRow& row : combine.table.params)
                writer_.row(combine, row);
        }
        writeGeneration();
    }

    void bind() {
        std::vector<Part> parts = bindingCall(emission_, unit_, holder_.path);
        if (!parts.empty() && writer_.takes(parts))
            writer_.add(std::move(parts));
    }

    [[nodiscard]] Holder part(const StructTable& table, const void* values, const void* initial,
                              const std::string& key, std::string_view variable) const {
        return {table,
                values,
                initial,
                own(key),
                fmt::format("{}.{}", holder_.state, key),
                joined(holder_.variable, variable),
                unit_.target};
    }

    void writeGeneration() {
        std::vector<Holder> eyePlanes;
        for (std::size_t i = 0; i < generatedCoordinates.size(); ++i) {
            const auto& [member, key, letter] = generatedCoordinates[i];
            const TexGen& generated = unit_.*member;
            const Holder holder = part(texGenTable(i), &generated, &(initialUnit().*member), key(), letter);
            writer_.row(holder, memberId<&TexGen::enabled>);
            if (!generated.enabled &&
                !writer_.moves(fmt::format("{}.{}", holder.path, keyOf<&TexGen::enabled>())))
                continue;
            writer_.row(holder, memberId<&TexGen::mode>);
            const auto mayBe = [&](TexGenMode mode) {
                return emission_.keys.mayBe(fmt::format("{}.{}", holder.path, keyOf<&TexGen::mode>()),
                                            generated.mode, [&](TexGenMode is) { return is == mode; });
            };
            if (mayBe(TexGenMode::ObjectLinear))
                writer_.row(holder, memberId<&TexGen::objectPlane>);
            const std::string plane = fmt::format("{}.{}", holder.path, keyOf<&TexGen::eyePlane>());
            if (mayBe(TexGenMode::EyeLinear) && writer_.takes({{Part::Kind::Number, {}, plane}}))
                eyePlanes.push_back(holder);
        }
        if (eyePlanes.empty())
            return;
        // OpenGL multiplies them by the inverse of the modelview matrix (section 2.11.4).
        const ParamRow& row = *findParam(texGenTable(0), keyOf<&TexGen::eyePlane>());
        const bool needed = std::ranges::any_of(
            eyePlanes, [&](const Holder& holder) { return writer_.differs(holder, row); });
        const bool hasCamera = needed && emission_.inFrame;
        writer_.add("glPushMatrix();", hasCamera);
        writer_.add("glLoadIdentity();", hasCamera);
        for (const Holder& holder : eyePlanes)
            writer_.row(holder, memberId<&TexGen::eyePlane>);
        writer_.add("glPopMatrix();", hasCamera);
    }

    void writeMatrix() {
        bool& hasMatrix = emission_.hasMatrix[index_];
        const bool flips = emission_.lateFlipOf(pass_, index_) == LateFlip::Matrix;
        if (unit_.matrix.empty() && !flips && !hasMatrix)
            return;
        writer_.add(fmt::format("glMatrixMode({});", textureMode));
        writer_.add("glLoadIdentity();");
        if (flips) {
            writer_.add("glTranslatef(0.0f, 1.0f, 0.0f); /* t becomes 1 - t: the image is upside down */");
            writer_.add("glScalef(1.0f, -1.0f, 1.0f);");
        }
        for (std::size_t i = firstStep(unit_); i < unit_.matrix.size(); ++i)
            StepWriter(emission_, holder_, i).write();
        writer_.add(fmt::format("glMatrixMode({});", modelViewMode));
        hasMatrix = flips || !unit_.matrix.empty();
    }

    Emission& emission_;
    CodeWriter& writer_;
    const Unit& unit_;
    /// Then the matrices of all units are set in every frame: when one is, Mesa 22.3 forgets those that
    /// aren't.
    bool movesSomeMatrix_;
    std::size_t pass_;
    std::size_t index_;
    Holder holder_;
};

} // namespace

std::vector<Part> bindingCall(Emission& emission, const Unit& unit, const std::string& unitPath) {
    const auto objectOf = [&](int texture) {
        const auto found = std::ranges::find(emission.objects,
                                             TextureObject{static_cast<std::size_t>(texture), unit.target});
        return static_cast<int>(found - emission.objects.begin());
    };
    const std::string path = fmt::format("{}.{}", unitPath, keyOf<&Unit::texture>());
    const int object = objectOf(unit.texture);
    if (object == static_cast<int>(emission.objects.size()))
        return {};
    // An index is the texture's own, but for one that is shown on a second target.
    const auto isOwn = [&](int texture) { return objectOf(texture) == texture; };
    if (emission.keys.moves(path) && !std::ranges::all_of(emission.keys.indicesOf(path, unit.texture), isOwn))
        emission.keys.refuse(path);
    const Part index = isOwn(unit.texture) ? whole(unit.texture, path) : plain(fmt::format("{}", object));
    return callWith("glBindTexture",
                    {plain(fmt::format("{}, textures[", rowOf(unit.target).name)), index, plain("]")});
}

std::size_t firstStep(const Unit& unit) {
    for (std::size_t i = unit.matrix.size(); i > 0; --i) {
        if (unit.matrix[i - 1].op == MatrixOp::Load)
            return i - 1;
    }
    return 0;
}

bool movesMatrix(const Emission& emission, std::size_t pass, std::size_t index) {
    const Unit& unit = emission.scene.passes[pass].units[index];
    return emission.keys.movesBelow(unitPath(pass, index, {keyOf<&Unit::matrix>() + "["})) ||
           std::any_of(unit.matrix.begin() + static_cast<std::ptrdiff_t>(firstStep(unit)), unit.matrix.end(),
                       [](const MatrixStep& step) {
                           return step.op != MatrixOp::Multiply && step.op != MatrixOp::Load &&
                                  step.op != MatrixOp::Projector &&
                                  (step.rate != glm::vec3(0) ||
                                   (step.op == MatrixOp::Rotate && step.angleRate != 0));
                       });
}

void writeMovingUnits(Emission& emission, std::size_t pass) {
    for (std::size_t i = 0; i < maxUnits; ++i)
        UnitWriter(emission, pass, i).writeMoving();
}

void writeUnits(Emission& emission, std::size_t pass) {
    for (const bool on : {true, false}) { // what is off comes last, where all calls are shown
        for (std::size_t i = 0; i < maxUnits; ++i) {
            if (emission.scene.passes[pass].units[i].enabled == on)
                UnitWriter(emission, pass, i).write();
        }
    }
}

} // namespace texplorer::emit
