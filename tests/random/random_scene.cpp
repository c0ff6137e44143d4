#include "tests/random/random_scene.h"

#include "core/conform/dice.h"
#include "core/gl/combine_arguments.h"
#include "core/reference/sampling/lod.h"
#include "core/scene/model_mesh.h"
#include "core/scene/params/params.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace texplorer::random {

namespace {

using conform::Dice;

constexpr std::size_t maxOwnCoordinates = 600; // a larger mesh keeps its own: nobody reads lists that long

class Generator {
public:
    Generator(Temper temper, std::span<const std::string> files, Dice& dice)
        : temper_(temper)
        , files_(files)
        , dice_(dice) {}

    void fill(const StructTable& table, void* owner) {
        for (const ParamRow& row : table.params)
            row.write(owner, valueOf(row, row.read(owner)));
        for (const ChildRow& child : table.children) {
            child.resize(owner, countOf(child));
            for (std::size_t i = 0; i < child.size(owner); ++i)
                fill(*child.table, child.at(owner, i));
        }
    }

    /// One coordinate of a vertex: rows don't limit it, so that it goes as far as a float.
    float coordinate() { return isWild() ? dice_.of(unlimited) : dice_.number(-2, 3); }

private:
    static constexpr float denormal = std::numeric_limits<float>::denorm_min();
    static constexpr std::array unlimited{0.0F,
                                          -0.0F,
                                          denormal,
                                          -denormal,
                                          1e-40F,
                                          1e-20F,
                                          0.5F,
                                          1.0F,
                                          1e6F,
                                          -1e6F,
                                          16777216.5F,
                                          3e17F,
                                          1e20F,
                                          -1e20F,
                                          3e38F,
                                          -3e38F,
                                          std::numeric_limits<float>::max()};

    bool isWild() {
        switch (temper_) {
        case Temper::Comparable:
        case Temper::Ordinary:
            break;
        case Temper::Mixed:
            return dice_.chance(8);
        case Temper::Wild:
            return dice_.chance(2);
        }
        return false;
    }

    float numberOf(const Range& range, float start) {
        if (!isWild())
            return std::clamp(start + dice_.number(-100, 100) * range.step, range.min, range.max);
        constexpr float far = std::numeric_limits<float>::infinity();
        const std::array choices{range.min,
                                 range.max,
                                 std::nextafter(range.min, far),
                                 std::nextafter(range.max, -far),
                                 0.0F,
                                 -0.0F,
                                 denormal,
                                 -denormal,
                                 1e-40F,
                                 1e-20F,
                                 static_cast<float>(dice_.below(12)), // a level, a count
                                 dice_.number(range.min, range.max)};
        return std::clamp(dice_.of(choices), range.min, range.max);
    }

    Value valueOf(const ParamRow& row, const Value& start) {
        switch (row.kind) {
        case Kind::Bool:
            return dice_.chance(2);
        case Kind::Int:
            return static_cast<int>(
                std::lround(numberOf(row.range, static_cast<float>(std::get<int>(start)))));
        case Kind::Float:
            return numberOf(row.range, std::get<float>(start));
        case Kind::Vec3:
            return vectorOf(row.range, std::get<glm::vec3>(start));
        case Kind::Vec4:
        case Kind::Color:
            return vectorOf(row.range, std::get<glm::vec4>(start));
        case Kind::Enum:
            return EnumValue{dice_.of(row.choices).value};
        case Kind::Text:
            return files_.empty() ? std::string() : dice_.of(files_);
        case Kind::TexCoordList:
            break; // as many as the mesh has vertices, which no row knows
        }
        return start;
    }

    template<class Vector>
    Vector vectorOf(const Range& range, Vector vector) {
        for (int i = 0; i < Vector::length(); ++i)
            vector[i] = numberOf(range, vector[i]);
        return vector;
    }

    std::size_t countOf(const ChildRow& child) {
        if (child.minCount == child.maxCount)
            return child.minCount;
        const auto most = static_cast<int>(child.maxCount - child.minCount);
        const std::array wild{0, most, dice_.below(most + 1)};
        return child.minCount +
               static_cast<std::size_t>(isWild() ? dice_.of(wild) : dice_.below(std::min(4, most + 1)));
    }

    Temper temper_;
    std::span<const std::string> files_;
    Dice& dice_;
};

/// What no row can know alone: how members must fit each other.
void fit(Scene& scene, Generator& generator, Dice& dice, bool hasFiles) {
    for (Model& model : scene.models) {
        const std::size_t count = vertexCountOf(model);
        for (TexCoords& list : model.texCoords) {
            if (count > maxOwnCoordinates || !dice.chance(3))
                continue;
            list.resize(count);
            for (glm::vec4& each : list) {
                each = {generator.coordinate(), generator.coordinate(), generator.coordinate(), 1};
                if (dice.chance(8))
                    each.q = generator.coordinate();
            }
        }
    }
    for (Texture& texture : scene.textures) {
        if (!hasFiles)
            texture.source = SourceKind::Pattern;
    }
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units) {
            if (scene.textures.empty())
                unit.enabled = false;
            else
                unit.texture %= static_cast<int>(scene.textures.size());
        }
    }
}

bool passesSomething(CompareFunc func) {
    return func == CompareFunc::Less || func == CompareFunc::LessEqual || func == CompareFunc::NotEqual ||
           func == CompareFunc::Always;
}

/// By a picture of one colour nothing is told: one model at least, and what the first pass draws of it.
void letItBeSeen(Scene& scene) {
    if (scene.models.empty())
        scene.models.emplace_back();
    scene.models.front().visible = true;
    Pass& pass = scene.passes.front();
    pass.enabled = true;
    pass.alphaTest = false;
    if (!passesSomething(pass.depthFunc)) // against a depth of 1
        pass.depthTest = false;
    if (pass.blendSrc == BlendFactor::Zero)
        pass.blendSrc = BlendFactor::One;
    if (!scene.textures.empty())
        pass.units[0].enabled = true;
}

/// What drivers do otherwise than the specification, or may.
void takeAwayWhatDiffers(Scene& scene) {
    scene.view.perspectiveHint = HintMode::DontCare;
    for (Model& model : scene.models) {
        for (TexCoords& list : model.texCoords) {
            for (glm::vec4& each : list)
                each.q = 1;
        }
    }
    for (Texture& texture : scene.textures) {
        texture.border = 0;
        texture.maxAnisotropy = 1;
        if (texture.mipmaps == MipPolicy::None || texture.mipmaps == MipPolicy::Missing)
            texture.mipmaps = MipPolicy::Generated; // an incomplete texture isn't seen
        if (texture.compression == Compression::Driver)
            texture.compression = Compression::FromFile;
        if (reference::switchOverOf(texture.magFilter, texture.minFilter) > 0)
            texture.magFilter = MagFilter::Nearest;
    }
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units) {
            unit.texGenQ.enabled = false;
            if (!unit.enabled)
                continue;
            Texture& texture = scene.textures[static_cast<std::size_t>(unit.texture)];
            Combine& c = unit.combine;
            for (CombineSource* source : {&c.source0Rgb, &c.source1Rgb, &c.source2Rgb, &c.source0Alpha,
                                          &c.source1Alpha, &c.source2Alpha}) {
                const std::optional<std::size_t> asked = crossbarUnit(*source);
                if (asked && !pass.units[*asked].enabled)
                    *source = CombineSource::Texture;
            }
            if (unit.envMode == EnvMode::Decal)
                texture.internalFormat = BaseFormat::Rgba;
            if (unit.target == Target::CubeMap)
                texture.wrapS = texture.wrapT = Wrap::ClampToEdge;
        }
    }
}

} // namespace

RandomScene randomScene(unsigned seed, int number, std::span<const std::string> files) {
    constexpr std::array tempers{Temper::Comparable, Temper::Ordinary, Temper::Mixed, Temper::Wild};
    Dice dice("random", seed, number);
    RandomScene made{dice.of(tempers), defaultScene()};
    Generator generator(made.temper, files, dice);
    generator.fill(sceneTable(), &made.scene);
    fit(made.scene, generator, dice, !files.empty());
    if (made.temper != Temper::Wild)
        letItBeSeen(made.scene);
    if (made.temper == Temper::Comparable)
        takeAwayWhatDiffers(made.scene);
    return made;
}

} // namespace texplorer::random
