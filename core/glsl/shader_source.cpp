#include "texplorer/glsl/shader_source.h"

#include "texplorer/gl/combine_arguments.h"
#include "texplorer/glsl/sampling_source.h"
#include "texplorer/glsl/source_writer.h"
#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/texture_matrix.h"

#include <fmt/core.h>

#include <algorithm>
#include <span>

namespace texplorer::glsl {

namespace {

struct Coordinate {
    char name;
    char member; ///< GLSL's
    TexGen Unit::*state;
};
constexpr std::array coordinates{Coordinate{'s', 's', &Unit::texGenS}, Coordinate{'t', 't', &Unit::texGenT},
                                 Coordinate{'r', 'p', &Unit::texGenR}, Coordinate{'q', 'q', &Unit::texGenQ}};

/// Everything that both stages are written from.
struct Plan {
    const Scene& scene;
    std::size_t index;
    const SampledUnits& units;
    Dialect dialect = Dialect::Glsl330;
    const Pass& pass = scene.passes[index];

    [[nodiscard]] bool separateSpecular() const {
        return pass.lighting && scene.light.colorControl == ColorControl::SeparateSpecular;
    }
    /// How colours and coordinates come from the vertices to the fragments.
    [[nodiscard]] bool affine() const { return scene.view.perspectiveHint == HintMode::Fastest; }
    [[nodiscard]] bool affineColors() const {
        return affine() && scene.material.shadeModel == ShadeModel::Smooth;
    }
    /// Whether there is something that the rasteriser must not divide by w: see vertex.glsl.
    [[nodiscard]] bool needsW() const { return affineColors() || (affine() && pass.fog.enabled); }
    [[nodiscard]] bool twoSided() const { return pass.lighting && scene.light.twoSide; }
    [[nodiscard]] std::string version() const {
        return dialect == Dialect::Es300 ? "version of OpenGL ES" : "version";
    }
    [[nodiscard]] std::string shading() const {
        const std::string name = nameOf(scene.material.shadeModel);
        return affineColors() ? fmt::format("{} {}", name, nameOf(HintMode::Fastest)) : name;
    }
    /// A piece about the fog's distance.
    [[nodiscard]] std::string fogPiece(const std::string& name) const {
        return affine() ? fmt::format("{} {}", name, nameOf(HintMode::Fastest)) : name;
    }

    /// Whether glColor is all that lighting needs of the materials, but for the highlight.
    [[nodiscard]] bool colorsAreMaterials() const {
        constexpr glm::vec3 none(0);
        return std::ranges::all_of(drawnModels(scene, pass), [&](std::size_t model) {
            const Material& material = materialOf(scene, scene.models[model]);
            return material.colorMaterial && glm::vec3(material.emission) == none;
        });
    }

    /// Whether the coordinates of one of its units, which forEachUnit gives, have a texture matrix.
    [[nodiscard]] bool hasMatrix(const Unit& unit) const {
        const auto number = static_cast<std::size_t>(&unit - pass.units.data());
        return hasTextureMatrix(scene, index, number, *units[number]);
    }

    void forEachUnit(auto each) const {
        for (std::size_t i = 0; i < units.size(); ++i) {
            if (units[i])
                each(pass.units[i], *units[i], std::to_string(i));
        }
    }
};

void writeLighting(SourceWriter& body, const Plan& plan) {
    const Light& light = plan.scene.light;
    body.add("lighting", light.position.w == 0 ? "directional light" : "positional light");
    body.add("lighting", light.localViewer ? "local viewer" : "infinite viewer");
    const std::string reflectance = plan.colorsAreMaterials() ? "color material" : "material";
    body.add("lighting", "terms");
    body.add("lighting", reflectance);
    body.add("lighting", nameOf(light.colorControl));
    if (!plan.twoSided())
        return;
    body.add("lighting", "begin back");
    body.add("lighting", "terms");
    body.add("lighting", reflectance);
    body.add("lighting", "back " + nameOf(light.colorControl));
    body.add("lighting", "end back");
}

void writeCoordinate(SourceWriter& body, const Plan& plan, const Unit& unit, const std::string& index) {
    body.add("vertex", "coordinate", {{"UNIT", index}});
    for (const Coordinate& coordinate : coordinates) {
        const TexGen& generated = unit.*coordinate.state;
        if (generated.enabled)
            body.add("texgen", nameOf(generated.mode),
                     {{"UNIT", index},
                      {"COORD", std::string(1, coordinate.name)},
                      {"MEMBER", std::string(1, coordinate.member)}});
    }
    body.add("vertex", plan.hasMatrix(unit) ? "coordinate with matrix" : "coordinate as it is",
             {{"UNIT", index}});
}

Result<StageSource> vertexStage(const Plan& plan, const ShaderPieces& pieces) {
    SourceWriter body(pieces);
    if (plan.pass.lighting)
        writeLighting(body, plan);
    else
        body.add("vertex", "unlit");
    plan.forEachUnit([&](const Unit& unit, const SampledUnit&, const std::string& index) {
        writeCoordinate(body, plan, unit, index);
        if (plan.affine()) // `noperspective` would say it, but Mesa 22.3 goes wrong where it clips
            body.add("vertex", "coordinate without perspective", {{"UNIT", index}});
    });
    if (plan.needsW())
        body.add("vertex", "w");
    if (plan.affineColors())
        body.add("vertex", "colors without perspective");
    if (plan.affineColors() && plan.separateSpecular())
        body.add("vertex", "secondary color without perspective");
    if (plan.affineColors() && plan.twoSided())
        body.add("vertex", "back color without perspective");
    if (plan.affineColors() && plan.twoSided() && plan.separateSpecular())
        body.add("vertex", "back secondary color without perspective");
    if (plan.pass.fog.enabled)
        body.add("fog", plan.fogPiece("distance"));
    if (plan.dialect == Dialect::Es300)
        body.add("vertex", "point size");
    body.add("vertex", "end");

    SourceWriter stage(pieces);
    stage.add("vertex", plan.version());
    stage.add("vertex", "attributes");
    for (std::size_t i = 0; i < plan.units.size(); ++i) {
        if (plan.units[i])
            stage.add("vertex", "coordinate attribute",
                      {{"UNIT", std::to_string(i)}, {"LOCATION", std::to_string(firstCoordAttribute + i)}});
    }
    stage.add("vertex", "matrices");
    if (body.mentions("eyePosition"))
        stage.add("vertex", "model-view matrix");
    if (body.mentions("eyeNormal"))
        stage.add("vertex", "normal matrix");
    if (plan.dialect == Dialect::Es300)
        stage.add("vertex", "point size uniform");
    if (plan.pass.lighting)
        stage.add("lighting", "uniforms");
    if (body.mentions("materialDiffuse"))
        stage.add("lighting", "material uniforms");
    plan.forEachUnit([&](const Unit& unit, const SampledUnit&, const std::string& index) {
        for (const Coordinate& coordinate : coordinates) {
            const std::string name(1, coordinate.name);
            if (body.mentions(fmt::format("plane{}{}", index, name)))
                stage.add("texgen", "plane", {{"UNIT", index}, {"COORD", name}});
        }
        if (plan.hasMatrix(unit))
            stage.add("vertex", "texture matrix", {{"UNIT", index}});
    });
    stage.add("vertex", "outputs " + plan.shading());
    if (plan.separateSpecular())
        stage.add("vertex", "secondary output " + plan.shading());
    if (plan.twoSided())
        stage.add("vertex", "back output " + plan.shading());
    if (plan.twoSided() && plan.separateSpecular())
        stage.add("vertex", "back secondary output " + plan.shading());
    if (plan.needsW())
        stage.add("vertex", "w output");
    if (plan.pass.fog.enabled)
        stage.add("fog", plan.fogPiece("output"));
    plan.forEachUnit([&](const Unit&, const SampledUnit&, const std::string& index) {
        stage.add("vertex", "coordinate output", {{"UNIT", index}});
    });
    const bool reflects = body.mentions("reflectionVector(");
    if (reflects || body.mentions("direction(") || body.mentions("eyeNormal"))
        stage.add("vertex", "direction");
    if (reflects)
        stage.add("texgen", "reflection vector");
    if (body.mentions("sphereMap("))
        stage.add("texgen", "sphere map");
    stage.add("vertex", "begin");
    if (body.mentions("eyePosition"))
        stage.add("vertex", "eye position");
    if (body.mentions("eyeNormal"))
        stage.add("vertex", "eye normal");
    stage.append(std::move(body));
    return std::move(stage).finish();
}

/// Where an argument of GL_COMBINE comes from; empty: the texture of a unit that has none.
std::string sourceOf(CombineSource source, const std::string& index, const SampledUnits& units) {
    switch (source) {
    case CombineSource::Texture:
        return "texel" + index;
    case CombineSource::Constant:
        return "environmentColor" + index;
    case CombineSource::PrimaryColor:
        return "primaryColor";
    case CombineSource::Previous:
        return "color";
    default:
        break;
    }
    const std::optional<std::size_t> other = crossbarUnit(source);
    return other && *other < units.size() && units[*other] ? fmt::format("texel{}", *other) : std::string();
}

/// The arguments, the function and the scale of the colour ("rgb") or of "alpha". False where an argument is
/// undefined.
bool writeFunction(SourceWriter& body, const std::string& what, const std::string& function,
                   std::span<const CombineArgument> arguments, CombineScale scale, const std::string& index,
                   const SampledUnits& units) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string source = sourceOf(arguments[i].source, index, units);
        if (source.empty())
            return false;
        body.add("combine", fmt::format("{} {}", what, nameOf(arguments[i].operand)),
                 {{"INDEX", std::to_string(i)}, {"SOURCE", source}});
    }
    body.add("combine", fmt::format("{} {}", what, function));
    if (scale != CombineScale::One)
        body.add("combine", fmt::format("{} scale {}", what, nameOf(scale)));
    return true;
}

void writeCombine(SourceWriter& body, const Combine& combine, const std::string& index,
                  const SampledUnits& units, const ShaderPieces& pieces) {
    SourceWriter block(pieces);
    block.add("combine", "begin", {{"UNIT", index}});
    const auto used = [](const CombineArguments& arguments, int count) {
        return std::span(arguments).first(static_cast<std::size_t>(count));
    };
    const CombineArguments rgb = rgbArguments(combine);
    bool defined = writeFunction(block, "rgb", nameOf(combine.rgb), used(rgb, argumentCount(combine.rgb)),
                                 combine.rgbScale, index, units);
    if (combine.rgb == CombineRgb::Dot3Rgba) {
        block.add("combine", "alpha of the dot product");
        if (combine.alphaScale != CombineScale::One)
            block.add("combine", "alpha scale " + nameOf(combine.alphaScale));
    } else {
        const CombineArguments alpha = alphaArguments(combine);
        defined =
            writeFunction(block, "alpha", nameOf(combine.alpha), used(alpha, argumentCount(combine.alpha)),
                          combine.alphaScale, index, units) &&
            defined;
    }
    block.add("combine", "end");
    if (defined)
        body.append(std::move(block));
    else
        body.add("combine", "undefined", {{"UNIT", index}});
}

/// The primary or secondary colour, if it is not an unchanged input.
void writeVaryingColor(SourceWriter& body, const Plan& plan, const std::string& which) {
    if (plan.twoSided() || plan.affineColors())
        body.add("fragment", fmt::format("{} color{}{}", which, plan.twoSided() ? " of the side" : "",
                                         plan.affineColors() ? " without perspective" : ""));
}

bool endsAtTheEdge(const SampledUnit& sampled) {
    return std::ranges::find(sampled.ends, true) != sampled.ends.end();
}

/// The piece that reads the texture.
std::string lookupOf(const Unit& unit, const SampledUnit& sampled) {
    if (endsAtTheEdge(sampled))
        return fmt::format("lookup {} that ends", nameOf(unit.target));
    if (sampled.compares)
        return "lookup that compares";
    if (sampled.hasDepths)
        return "lookup of a depth";
    return unit.target == Target::CubeMap ? "lookup of a direction" : "lookup";
}

/// The colour of a depth.
void writeDepth(SourceWriter& body, const SampledUnit& sampled, const std::string& index) {
    if (sampled.hasDepths)
        body.add("fragment", "depth as " + nameOf(sampled.format), {{"UNIT", index}});
}

Result<StageSource> fragmentStage(const Plan& plan, const ShaderPieces& pieces) {
    SourceWriter body(pieces);
    // All texels first: with crossbar a unit may ask for the texel of a later one.
    plan.forEachUnit([&](const Unit& unit, const SampledUnit& sampled, const std::string& index) {
        if (sampled.sampler) {
            body.add("sampling", sampled.hasDepths ? "lookup of a depth" : "lookup", {{"UNIT", index}});
            return writeDepth(body, sampled, index);
        }
        if (endsAtTheEdge(sampled))
            body.add("fragment", "place that ends", {{"UNIT", index}});
        for (std::size_t i = 0; i < sampled.ends.size(); ++i) {
            if (sampled.ends[i])
                body.add("fragment", "end of a coordinate",
                         {{"UNIT", index}, {"MEMBER", std::string(1, coordinates[i].member)}});
        }
        body.add("fragment", lookupOf(unit, sampled) + (unit.lodBias == 0 ? "" : " with bias"),
                 {{"UNIT", index}});
        writeDepth(body, sampled, index);
    });
    writeVaryingColor(body, plan, "primary");
    body.add("fragment", "primary color");
    plan.forEachUnit([&](const Unit& unit, const SampledUnit& sampled, const std::string& index) {
        if (unit.envMode == EnvMode::Combine)
            writeCombine(body, unit.combine, index, plan.units, pieces);
        else
            body.add("environment", fmt::format("{} {}", nameOf(unit.envMode), nameOf(sampled.format)),
                     {{"UNIT", index}});
        if (sampled.isUnclamped && unit.envMode != EnvMode::Combine)
            body.add("environment", "unclamped");
    });
    if (plan.separateSpecular()) {
        writeVaryingColor(body, plan, "secondary");
        body.add("fragment", "color sum");
    }
    const Fog& fog = plan.pass.fog;
    if (fog.enabled) {
        body.add("fog", plan.fogPiece("begin"));
        body.add("fog", nameOf(fog.mode));
        body.add("fog", "end");
    }
    const bool tested = plan.pass.alphaTest && plan.pass.alphaFunc != CompareFunc::Always;
    if (tested) {
        body.add("fragment", "alpha test");
        body.add("fragment", "alpha " + nameOf(plan.pass.alphaFunc));
    }
    body.add("fragment", "end");

    SourceWriter stage(pieces);
    stage.add("fragment", plan.version());
    stage.add("fragment", "inputs " + plan.shading());
    if (plan.separateSpecular())
        stage.add("fragment", "secondary input " + plan.shading());
    if (plan.twoSided())
        stage.add("fragment", "back input " + plan.shading());
    if (plan.twoSided() && plan.separateSpecular())
        stage.add("fragment", "back secondary input " + plan.shading());
    if (plan.needsW())
        stage.add("fragment", "w input");
    if (fog.enabled)
        stage.add("fog", plan.fogPiece("input"));
    plan.forEachUnit([&](const Unit& unit, const SampledUnit& sampled, const std::string& index) {
        const std::vector<Substitution> names{{"UNIT", index}};
        stage.add("fragment", "coordinate input", names);
        if (!sampled.sampler) {
            const std::string sampler = "sampler " + nameOf(unit.target);
            stage.add("fragment",
                      sampled.compares ? fmt::format("{} {}", sampler, nameOf(CompareMode::RToTexture))
                                       : sampler,
                      names);
            if (unit.lodBias != 0)
                stage.add("fragment", "bias", names);
        }
        if (body.mentions("environmentColor" + index))
            stage.add("fragment", "environment color", names);
    });
    if (fog.enabled)
        stage.add("fog", "uniforms " + nameOf(fog.mode));
    if (tested)
        stage.add("fragment", "alpha reference");
    writeSampling(stage, plan.pass, plan.units, pieces);
    stage.add("fragment", "outputs");
    stage.add("fragment", "begin");
    stage.append(std::move(body));
    return std::move(stage).finish();
}

} // namespace

bool hasTextureMatrix(const Scene& scene, std::size_t pass, std::size_t unit, const SampledUnit& sampled) {
    return sampled.lateFlip == LateFlip::Matrix ||
           !scene.passes[pass].units[unit].matrix.empty() || // also where it draws nothing
           std::ranges::any_of(drawnModels(scene, scene.passes[pass]), [&](std::size_t model) {
               return !textureSteps(scene, pass, unit, model).empty();
           });
}

Result<ShaderSource> shaderSource(const Scene& scene, std::size_t pass, const SampledUnits& units,
                                  const ShaderPieces& pieces, Dialect dialect) {
    const Plan plan{scene, pass, units, dialect};
    Result<StageSource> vertex = vertexStage(plan, pieces);
    if (!vertex)
        return fail(vertex.error());
    Result<StageSource> fragment = fragmentStage(plan, pieces);
    if (!fragment)
        return fail(fragment.error());
    return ShaderSource{std::move(*vertex), std::move(*fragment)};
}

} // namespace texplorer::glsl
