#include "tests/random/random_scene.h"

#include "tests/random/random_skip.h"
#include "texplorer/conform/dice.h"
#include "texplorer/gl/combine_arguments.h"
#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/params.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>

namespace texplorer::random {

namespace {

using conform::Dice;

constexpr std::size_t maxOwnCoordinates =
    600; // a larger mesh keeps its own: such long lists are not readable
constexpr int maxVertices = 60;
constexpr int maxIndices = 90;

constexpr std::array<std::string_view, 8> names{"",       "Floor", "two words",     "\"in quotes\"",
                                                "a/b\\c", "{} %s", "W\xC3\xBCrfel", "two\nlines"};

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

    // Coordinates of vertices. Rows do not limit them: they take the whole range of a float.
    float coordinate() { return isWild() ? dice_.of(unlimited) : dice_.number(-2, 3); }
    glm::vec4 texCoord() {
        glm::vec4 made{coordinate(), coordinate(), coordinate(), 1};
        if (dice_.chance(8))
            made.q = coordinate();
        return made;
    }
    /// A place about as far away as the vertices of the other shapes; never 0, so that it can be a normal as
    /// well.
    glm::vec3 place() {
        const auto number = [&] { return isWild() ? dice_.of(unlimited) : dice_.number(-1.5F, 1.5F); };
        return {number(), number(), number()};
    }
    glm::vec4 color() { return vectorOf(Range{0, 1, 0.005F, {}}, glm::vec4(0.5F)); }
    Value valueOf(const ParamRow& row, const Value& start);

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

Value Generator::valueOf(const ParamRow& row, const Value& start) {
    switch (row.kind) {
    case Kind::Bool:
        return dice_.chance(2);
    case Kind::Int:
        return static_cast<int>(std::lround(numberOf(row.range, static_cast<float>(std::get<int>(start)))));
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
        if (row.member == memberId<&MeshData::file>)
            return std::string(); // the vertices are random
        if (row.member != memberId<&Texture::file> && row.member != memberId<&GivenLevel::file> &&
            row.member != memberId<&ImageStep::file> && row.member != memberId<&Subimage::file>)
            return std::string(dice_.of(names));
        return files_.empty() ? std::string() : dice_.of(files_);
    case Kind::Matrix: {
        auto matrix = std::get<glm::mat4>(start);
        for (int column = 0; column < 4; ++column)
            matrix[column] = vectorOf(row.range, matrix[column]);
        return matrix;
    }
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
    case Kind::IndexList:
        break; // rows do not contain their number and content
    }
    return start;
}

/// Vertices at random places, drawn in random order.
void fitMesh(MeshData& mesh, Generator& generator, Dice& dice) {
    const auto count = static_cast<std::size_t>(dice.below(maxVertices + 1));
    const auto fill = [&](auto& list, const auto& make) {
        for (std::size_t i = 0; i < count; ++i)
            list.push_back(make());
    };
    fill(mesh.positions, [&] { return generator.place(); });
    if (dice.chance(2))
        fill(mesh.normals, [&] { return generator.place(); });
    if (dice.chance(2))
        fill(mesh.colors, [&] { return generator.color(); });
    if (!dice.chance(4))
        fill(mesh.texCoords, [&] { return generator.texCoord(); });
    if (count == 0 || dice.chance(2))
        return;
    for (int i = dice.below(maxIndices + 1); i > 0; --i)
        mesh.indices.push_back(dice.below(static_cast<int>(count)));
}

/// Texture matrices are those of the passes alone: products of more steps leave little of an image.
void useOwnMatrices(Scene& scene) {
    for (Model& model : scene.models)
        model.units = {};
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units)
            unit.matrixStart = MatrixStart::Identity;
    }
}

/// Some of the models, each once and in any order.
std::vector<int> someModels(const Scene& scene, Dice& dice) {
    std::vector<int> all(scene.models.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<int> chosen;
    for (int left = dice.below(static_cast<int>(all.size()) + 1); left > 0; --left) {
        const auto next = all.begin() + dice.below(static_cast<int>(all.size()));
        chosen.push_back(*next);
        all.erase(next);
    }
    return chosen;
}

/// The parameters that may have keys, and their kind; lists with a value per vertex are too long for one.
struct Movable {
    std::string path;
    const ParamRow* row;
    Value value;
};

std::vector<Movable> movables(const Scene& scene) {
    std::vector<Movable> all;
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
        const bool isKey =
            row.member == memberId<&KeyFrame::time> || row.member == memberId<&KeyFrame::path> ||
            row.member == memberId<&KeyFrame::value> || row.member == memberId<&KeyFrame::easing>;
        const bool isList = row.maxCount > 0;
        const bool isFile =
            row.member == memberId<&MeshData::file> || row.member == memberId<&MeshData::part>;
        if (!isKey && !isList && !isFile)
            all.push_back({path, &row, value});
    });
    return all;
}

/// Some of the scene's parameters, most of them with several keys.
void fitKeys(Scene& scene, Generator& generator, Dice& dice, bool hasFiles) {
    const std::vector<Movable> all = movables(scene);
    std::size_t chosen = 0;
    for (KeyFrame& key : scene.timeline.keys) {
        if (chosen == 0 || dice.chance(3)) // the first parameter is the camera's: chance is enough for it
            chosen = static_cast<std::size_t>(dice.below(static_cast<int>(all.size())));
        const auto& [path, row, initial] = all[chosen];
        Value value = generator.valueOf(*row, initial);
        const MemberId member = row->member;
        if (member == memberId<&Unit::texture>)
            value = std::get<int>(value) % std::max(1, static_cast<int>(scene.textures.size()));
        if ((member == memberId<&Unit::enabled> && scene.textures.empty()) ||
            (!hasFiles && row->key == "source"))
            value = initial;
        key.path = path;
        key.value = formatValue(*row, value);
    }
}

/// Most textures' uploads fit, and OpenGL takes the formats and types of most others.
void fitUpload(Texture& texture, Temper temper, Dice& dice) {
    constexpr std::array alignments{1, 2, 4, 8};
    Upload& upload = texture.upload;
    upload.custom = upload.custom && dice.chance(2);
    if (temper == Temper::Wild && dice.chance(3))
        return;
    upload.alignment = dice.of(alignments);
    upload.memoryAlignment = dice.of(alignments);
    if (isDepth(texture.internalFormat))
        upload.format = TransferFormat::DepthComponent;
    while (!isDepth(texture.internalFormat) && upload.format == TransferFormat::DepthComponent)
        upload.format = dice.any<TransferFormat>();
    while (!checkLayout({upload.format, upload.type}))
        upload.type = dice.any<TransferType>();
    while (!checkLayout({upload.memoryFormat, upload.memoryType}))
        upload.memoryType = dice.any<TransferType>();
    if (upload.type == TransferType::Float) { // of which other bytes may be no numbers
        upload.memory = MemoryRows::Layout;
        upload.memoryFormat = upload.format;
        upload.memoryType = upload.type;
        upload.swapBytes = false;
    }
    upload.rowLength %= 512; // not all of a computer's memory
    upload.skipRows %= 64;
}

/// Most are few and small, as each frame draws all of them, and most subimages fit. Programs can draw most
/// pictures.
void fitPicture(Texture& texture, Temper temper, Dice& dice) {
    if (temper == Temper::Wild && dice.chance(3)) {
        texture.pictureSize = texture.frames > 1 ? std::min(texture.pictureSize, 64) : texture.pictureSize;
        return;
    }
    if (texture.source == SourceKind::Picture && !dice.chance(4)) {
        texture.preparation.clear();
        texture.subimages.clear();
        texture.transparency = Transparency::File;
        texture.border = 0;
        texture.compression = Compression::None;
        texture.npot = NpotPolicy::Keep;
        texture.mipmaps = dice.chance(2) ? MipPolicy::None : MipPolicy::GenerateMipmap;
        texture.internalFormat = internalFormat(dice.any<BaseFormat>());
        texture.pictureCall = PictureCall::CopyTexSubImage;
    }
    texture.picture = 1 + texture.picture % 2;
    texture.pictureSize = 1 + texture.pictureSize % 64;
    texture.frames = 1 + texture.frames % 3;
    for (Subimage& subimage : texture.subimages) {
        subimage.level %= 8;
        for (int* offset : {&subimage.x, &subimage.y, &subimage.z})
            *offset %= 32;
    }
}

/// The relations between members that no row knows.
void fit(Scene& scene, Temper temper, Generator& generator, Dice& dice, bool hasFiles) {
    if (!dice.chance(3))
        useOwnMatrices(scene);
    for (Model& model : scene.models) {
        if (dice.chance(6)) // more often than as one of many shapes
            model.shape = Shape::Mesh;
        if (model.shape == Shape::Mesh || dice.chance(8)) // their own vertices, which are not drawn
            fitMesh(model.mesh, generator, dice);
        const std::size_t count = vertexCountOf(model);
        for (SharedList<glm::vec4>& list : model.texCoords) {
            if (count > maxOwnCoordinates || !dice.chance(3))
                continue;
            list.resize(count);
            for (glm::vec4& each : list.edit())
                each = generator.texCoord();
        }
    }
    for (Texture& texture : scene.textures) {
        fitUpload(texture, temper, dice);
        fitPicture(texture, temper, dice);
        if (hasFiles)
            continue;
        if (texture.source == SourceKind::File)
            texture.source = SourceKind::Pattern;
        for (GivenLevel& level : texture.levels)
            level.source = SourceKind::Pattern;
        for (ImageStep& step : texture.preparation)
            step.source = SourceKind::Pattern;
        for (Subimage& subimage : texture.subimages)
            subimage.source = SourceKind::Pattern;
    }
    for (Pass& pass : scene.passes) {
        if (temper != Temper::Wild || !dice.chance(3))
            pass.picture = dice.chance(3) ? 1 + pass.picture % 2 : 0;
        if (dice.chance(2))
            pass.models = someModels(scene, dice);
        for (Unit& unit : pass.units) {
            if (scene.textures.empty())
                unit.enabled = false;
            else
                unit.texture %= static_cast<int>(scene.textures.size());
            if (unit.enabled && !dice.chance(4) &&
                scene.textures[static_cast<std::size_t>(unit.texture)].source == SourceKind::Picture)
                unit.target = Target::Texture2D;
        }
    }
    fitKeys(scene, generator, dice, hasFiles);
    for (Model& model : scene.models) {
        const std::size_t count = vertexCountOf(model);
        for (std::vector<int>& leftOut : model.noTexCoord) {
            if (count == 0 || count > maxOwnCoordinates || !dice.chance(6))
                continue;
            for (int vertex = dice.below(4); std::cmp_less(vertex, count); vertex += 1 + dice.below(5))
                leftOut.push_back(vertex);
        }
    }
}

bool passesSomething(CompareFunc func) {
    return func == CompareFunc::Less || func == CompareFunc::LessEqual || func == CompareFunc::NotEqual ||
           func == CompareFunc::Always;
}

/// A picture of one colour is useless: at least one model is visible, and the first pass draws it.
void letItBeSeen(Scene& scene) {
    if (scene.models.empty())
        scene.models.emplace_back();
    Model& model = scene.models.front();
    model.visible = true;
    if (model.shape == Shape::Mesh && model.mesh.positions.size() < 3) {
        model.shape = Shape::Cube;
        model.texCoords = {};
        model.noTexCoord = {};
    }
    if (model.attachment == Attachment::Eye) // in front of it, like the others
        model.position.z = -scene.view.distance;
    Pass& pass = scene.passes.front();
    pass.enabled = true;
    if (!pass.models.empty() && std::ranges::find(pass.models, 0) == pass.models.end())
        pass.models.front() = 0;
    pass.alphaTest = false;
    if (!passesSomething(pass.depthFunc)) // against a depth of 1
        pass.depthTest = false;
    if (pass.blendSrc == BlendFactor::Zero)
        pass.blendSrc = BlendFactor::One;
    if (!scene.textures.empty())
        pass.units[0].enabled = true;
    for (Pass& each : scene.passes) { // as thin as the models are far away
        each.fog.density = std::min(each.fog.density / scene.view.distance, 1000.0F);
        each.fog.end = std::min(each.fog.end + 2 * scene.view.distance, 1000.0F);
    }
}

void keepLastRow(std::vector<MatrixStep>& steps) {
    for (MatrixStep& step : steps) {
        for (int column = 0; column < 4; ++column)
            step.matrix[column].w = column == 3 ? 1.0F : 0.0F;
    }
}

/// Removes what drivers draw differently from the specification, or may.
void takeAwayWhatDiffers(Scene& scene) {
    std::erase_if(scene.timeline.keys, [](const KeyFrame& key) {
        return !key.path.ends_with("color") && !key.path.ends_with("Color") &&
               !key.path.ends_with("azimuth") && !key.path.ends_with("rotation");
    });
    scene.view.perspectiveHint = HintMode::DontCare;
    const auto setQ = [](SharedList<glm::vec4>& list) {
        for (glm::vec4& each : list.edit())
            each.q = 1;
    };
    for (Model& model : scene.models) {
        std::ranges::for_each(model.texCoords, setQ);
        setQ(model.mesh.texCoords);
        for (ModelUnit& unit : model.units)
            keepLastRow(unit.matrix);
        model.pointSize = std::round(model.pointSize);
        const int width = reference::roundedSize(model.lineWidth);
        model.lineWidth = static_cast<float>(std::max(3, width - (width % 2 == 0 ? 1 : 0)));
        if (drawsAPartTwice(model) && model.shape == Shape::Torus) {
            model.stacks = minStacks + 1;
            model.texCoords = {}; // which don't fit any more
            model.noTexCoord = {};
        } else if (drawsAPartTwice(model)) {
            model.mesh.primitive = Primitive::Points;
            model.mesh.indices.clear();
        }
    }
    for (Texture& texture : scene.textures) {
        texture.border = 0;
        texture.maxAnisotropy = 1;
        if (const TransferType type = texture.upload.type;
            type == TransferType::Byte || type == TransferType::Short || type == TransferType::Int)
            texture.upload.custom = false;
        const bool isIncomplete = texture.mipmaps == MipPolicy::None || texture.mipmaps == MipPolicy::Missing;
        if (isIncomplete || isMadeByDriver(texture.mipmaps))
            texture.mipmaps = MipPolicy::Generated; // an incomplete texture is not visible
        if (texture.compression == Compression::Driver)
            texture.compression = Compression::FromFile;
        if (isGenericCompressed(texture.internalFormat))
            texture.internalFormat = internalFormat(baseFormat(texture.internalFormat));
        if (reference::switchOverOf(texture.magFilter, texture.minFilter) > 0)
            texture.magFilter = MagFilter::Nearest;
    }
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units) {
            unit.texGenQ.enabled = false;
            keepLastRow(unit.matrix);
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
            if (unit.envMode == EnvMode::Decal) {
                texture.upload.custom = texture.upload.custom && !isDepth(texture.internalFormat);
                texture.internalFormat = InternalFormat::Rgba;
            }
            if (unit.target == Target::CubeMap)
                texture.wrapS = texture.wrapT = Wrap::ClampToEdge;
        }
    }
}

} // namespace

void leaveQ(Scene& scene) {
    std::erase_if(scene.timeline.keys,
                  [](const KeyFrame& key) { return key.path.ends_with("." + keyOf<&MatrixStep::matrix>()); });
    const auto leave = [](std::vector<MatrixStep>& steps) {
        keepLastRow(steps);
        for (MatrixStep& step : steps) {
            if (step.op == MatrixOp::Projector)
                step.op = MatrixOp::Multiply;
        }
    };
    for (Model& model : scene.models) {
        for (ModelUnit& unit : model.units)
            leave(unit.matrix);
    }
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units)
            leave(unit.matrix);
    }
}

RandomScene randomScene(unsigned seed, int number, std::span<const std::string> files) {
    constexpr std::array tempers{Temper::Comparable, Temper::Ordinary, Temper::Mixed, Temper::Wild};
    Dice dice("random", seed, number);
    RandomScene made{dice.of(tempers), defaultScene()};
    Generator generator(made.temper, files, dice);
    generator.fill(sceneTable(), &made.scene);
    fit(made.scene, made.temper, generator, dice, !files.empty());
    if (made.temper != Temper::Wild)
        letItBeSeen(made.scene);
    if (made.temper == Temper::Comparable)
        takeAwayWhatDiffers(made.scene);
    return made;
}

} // namespace texplorer::random
