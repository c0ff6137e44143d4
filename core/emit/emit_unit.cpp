#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::emit {
namespace {

/// Whether the matrices of a pass are set in every frame: then those of all its units are, for when one is,
/// Mesa 22.3 forgets those that aren't.
bool areMatricesOfFrame(const Emission& emission, std::size_t pass) {
    const Scene& scene = emission.scene;
    for (std::size_t i = 0; i < maxUnits; ++i) {
        const Unit& unit = scene.passes[pass].units[i];
        PlacedSteps steps;
        pushSteps(scene, pass, i, std::nullopt, steps);
        if (unit.enabled && (unit.matrixStart != MatrixStart::Identity || anyMoves(emission, steps, i)))
            return true;
    }
    return modelsHaveSteps(scene, pass);
}

class UnitWriter {
public:
    UnitWriter(Emission& emission, std::size_t pass, std::size_t index)
        : emission_(emission)
        , writer_(emission.writer)
        , unit_(emission.scene.passes[pass].units[index])
        , areMatricesOfFrame_(areMatricesOfFrame(emission, pass))
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
        const int unitBefore = std::exchange(emission_.activeUnit, static_cast<int>(index_));
        const std::size_t size = writer_.size();
        writer_.take(Taking::Moving);
        if (const std::vector<Part> parts = switching(true, unit_.target); writer_.takes(parts))
            writer_.add(parts);
        bind();
        writeRows();
        writer_.take(Taking::All);
        if (areMatricesOfFrame_)
            writePassMatrix(emission_, pass_, index_, holder_.variable);
        if (writer_.size() == size) {
            writer_.truncate(start);
            emission_.activeUnit = unitBefore;
        }
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
        const bool isLeftToTheFrame = !emission_.inFrame && areMatricesOfFrame_;
        if (!isLeftToTheFrame)
            writePassMatrix(emission_, pass_, index_, holder_.variable);
    }

    /// The environment and the generation of coordinates.
    void writeRows() {
        const std::array taken{memberId<&Unit::enabled>, memberId<&Unit::target>, memberId<&Unit::texture>};
        for (const ParamRow& row : holder_.table.params) {
            if (!row.glCall.empty() && std::ranges::find(taken, row.member) == taken.end())
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

    Emission& emission_;
    CodeWriter& writer_;
    const Unit& unit_;
    bool areMatricesOfFrame_;
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
    const auto count = static_cast<int>(emission.objects.size());
    // An index is the texture's own, but for one that is shown on a second target.
    const auto isOwn = [&](int texture) { return texture < count && objectOf(texture) == texture; };
    if (emission.keys.moves(path) && !std::ranges::all_of(emission.keys.indicesOf(path, unit.texture), isOwn))
        emission.keys.refuse(path, N_("one of its textures is shown on several targets"));
    const int object = objectOf(unit.texture);
    if (object == count)
        return {};
    const Part index = isOwn(unit.texture) ? whole(unit.texture, path) : plain(fmt::format("{}", object));
    return callWith("glBindTexture",
                    {plain(fmt::format("{}, textures[", rowOf(unit.target).name)), index, plain("]")});
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
