#include "texplorer/glsl/sampling_source.h"

#include "texplorer/reference/sampling/lod.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace texplorer::glsl {

namespace {

constexpr const char* samplingFile = "sampling"; // of all pieces here

/// What functions mention, and the piece that declares it.
using Declared = std::pair<const char*, const char*>;
constexpr auto unitPieces = std::to_array<Declared>({{"borderColor", "border color"},
                                                     {"lod", "lod uniforms"},
                                                     {"lastLevel", "last level"},
                                                     {"anisotropy", "anisotropy"},
                                                     {"compared", "compared depth"}});
constexpr auto sharedPieces = std::to_array<Declared>({{"finite(", "finite"},
                                                       {"finiteDirection(", "finiteDirection"},
                                                       {"repeated(", "repeated"},
                                                       {"mirrored(", "mirrored"},
                                                       {"clampedToEdge(", "clampedToEdge"},
                                                       {"clampedToBorder(", "clampedToBorder"},
                                                       {"clamped(", "clamped"},
                                                       {"levelOfDetail(", "level of detail"},
                                                       {"faceCoords(", "faces"},
                                                       {"folded(", "folded"}});

/// The function of a wrap mode, which is also the name of its piece.
std::string wrapFunction(Wrap wrap) {
    switch (wrap) {
    case Wrap::Repeat:
        return "repeated";
    case Wrap::MirroredRepeat:
        return "mirrored";
    case Wrap::ClampToEdge:
        return "clampedToEdge";
    case Wrap::ClampToBorder:
        return "clampedToBorder";
    case Wrap::Clamp:
        break;
    }
    return "clamped";
}

bool leavesImage(Wrap wrap) {
    return wrap == Wrap::Clamp || wrap == Wrap::ClampToBorder;
}

/// The functions of one unit.
class UnitSampler {
public:
    UnitSampler(SourceWriter& body, Target target, const SampledUnit& unit, std::string index)
        : body_(body)
        , target_(target)
        , unit_(unit)
        , sampler_(*unit.sampler)
        , index_(std::move(index)) {}

    void write() const {
        writeTexel();
        if (isSeamless())
            add("around");
        const bool linear = sampler_.mag == MagFilter::Linear;
        const bool minLinear = reference::isLinear(sampler_.min);
        const bool minifies = needsLevelOfDetail(sampler_);
        if (!linear || (minifies && !minLinear))
            writeNearest();
        if (linear || (minifies && minLinear))
            writeLinear();
        writeFiltered(minifies);
        writeSample(minifies);
    }

private:
    using Words = std::vector<Substitution>;

    void add(const std::string& piece, Words words = {}) const {
        constexpr std::array rims{"ivec3(1, 0, 0)", "ivec3(1, 1, 0)", "ivec3(1)"};
        words.push_back({"UNIT", index_});
        words.push_back({"ROW", std::to_string(texelsPerRow)});
        words.push_back({"RIM", rims.at(static_cast<std::size_t>(axes() - 1))});
        body_.add(samplingFile, piece, words);
    }

    [[nodiscard]] int axes() const { return axesOf(target_); }
    [[nodiscard]] bool isSeamless() const { return sampler_.isSeamless && target_ == Target::CubeMap; }

    /// Section 3.8.7. ARB_seamless_cube_map has modes of its own.
    [[nodiscard]] Wrap wrap(int axis, bool linear) const {
        if (isSeamless())
            return linear ? Wrap::ClampToBorder : Wrap::ClampToEdge;
        return sampler_.wrap[static_cast<std::size_t>(axis)];
    }

    void writeTexel() const {
        bool leaves = false;
        for (int axis = 0; axis < axes(); ++axis)
            leaves = leaves || (leavesImage(wrap(axis, true)) && !isSeamless());
        add(sampler_.hasBorder ? "size without border" : "size");
        add("begin texel");
        if (sampler_.hasBorder)
            add("border image");
        add(leaves ? "texel or border" : "texel");
        if (unit_.compares)
            add("compare " + nameOf(sampler_.compare));
        add("end texel");
    }

    void writePlace(bool linear) const {
        add("place of " + nameOf(target_), {{"WRAP_S", wrapFunction(wrap(0, linear))},
                                            {"WRAP_T", wrapFunction(wrap(1, linear))},
                                            {"WRAP_R", wrapFunction(wrap(2, linear))}});
    }

    void writeNearest() const {
        add("begin nearest");
        writePlace(false);
        add("end nearest");
    }

    void writeLinear() const {
        constexpr std::array axisNames{"x", "y", "z"};
        add("begin linear");
        writePlace(true);
        add("corners");
        for (int axis = 0; axis < axes(); ++axis) {
            if (!leavesImage(wrap(axis, true)))
                add("next to it " + nameOf(wrap(axis, true)),
                    {{"AXIS", axisNames.at(static_cast<std::size_t>(axis))}});
        }
        if (target_ == Target::CubeMap)
            add("face of the corners");
        if (target_ == Target::Texture2D)
            add("only corner");
        add("end linear " + nameOf(target_), {{"READ", "texel" + index_ + (isSeamless() ? "Around" : "At")}});
    }

    [[nodiscard]] std::string filter(bool linear) const { return (linear ? "linear" : "nearest") + index_; }

    void writeFiltered(bool minifies) const {
        const std::string mag = filter(sampler_.mag == MagFilter::Linear);
        const std::string min = filter(reference::isLinear(sampler_.min));
        add("begin filtered");
        if (target_ == Target::CubeMap)
            add("on the face");
        if (minifies && (mag != min || reference::wantsMipmaps(sampler_.min)))
            add("magnified",
                {{"FILTERED", mag},
                 {"SWITCH", reference::switchOverOf(sampler_.mag, sampler_.min) > 0 ? "0.5" : "0.0"}});
        if (!minifies || !reference::wantsMipmaps(sampler_.min))
            add("one filter", {{"FILTERED", minifies ? min : mag}});
        else
            add(reference::blendsLevels(sampler_.min) ? "two levels" : "the nearest level",
                {{"FILTERED", min}});
    }

    void writeSample(bool minifies) const {
        add("begin sample", {{"FINITE", target_ == Target::CubeMap ? "finiteDirection" : "finite"}});
        if (unit_.compares)
            add("compares r");
        if (!minifies)
            return add("one sample without level of detail");
        add("changes");
        add("footprint " + nameOf(target_));
        add(sampler_.isAnisotropic ? "several samples" : "one sample");
    }

    SourceWriter& body_;
    Target target_;
    const SampledUnit& unit_;
    const WrittenSampler& sampler_;
    std::string index_;
};

} // namespace

bool needsLevelOfDetail(const WrittenSampler& sampler) {
    return sampler.isAnisotropic || reference::wantsMipmaps(sampler.min) ||
           reference::isLinear(sampler.min) != (sampler.mag == MagFilter::Linear);
}

void writeSampling(SourceWriter& stage, const Pass& pass, const SampledUnits& units,
                   const ShaderPieces& pieces) {
    SourceWriter body(pieces);
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (units[i] && units[i]->sampler)
            UnitSampler(body, pass.units[i].target, *units[i], std::to_string(i)).write();
    }
    // What the functions mention comes before them.
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (!units[i] || !units[i]->sampler)
            continue;
        const std::string index = std::to_string(i);
        const bool mips = reference::wantsMipmaps(units[i]->sampler->min);
        stage.add(samplingFile, "uniforms",
                  {{"UNIT", index},
                   {"ROW", std::to_string(texelsPerRow)},
                   {"LEVELS", std::to_string(mips ? maxListedLevels : 1)}});
        for (const auto& [word, piece] : unitPieces) {
            if (body.mentions(word + index))
                stage.add(samplingFile, piece, {{"UNIT", index}});
        }
    }
    for (const auto& [word, piece] : sharedPieces) {
        if (body.mentions(word))
            stage.add(samplingFile, piece);
    }
    stage.append(std::move(body));
}

} // namespace texplorer::glsl
