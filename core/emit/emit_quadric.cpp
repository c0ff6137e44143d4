// Spheres, cylinders and disks as GLU draws them.

#include "texplorer/emit/emission.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// GLU gives coordinates to unit 0 alone, and its axis is z, which coordinates of the model's space show.
bool isQuadric(Emission& emission, std::size_t index, const ModelForm& form) {
    constexpr int maxOfGlu = 239; // Mesa's GLU makes more slices or stacks as many
    const Scene& scene = emission.scene;
    const auto hasFew = [&](const Scene& other) {
        return std::max(other.models[index].slices, other.models[index].stacks) <= maxOfGlu;
    };
    const std::string path = elementOf<&Scene::models>(index);
    if (form.drawing != Drawing::Shape || scene.models[index].shape == Shape::Torus ||
        !emission.keys.decided(scene,
                               {fmt::format("{}.{}", path, keyOf<&Model::slices>()),
                                fmt::format("{}.{}", path, keyOf<&Model::stacks>())},
                               hasFew, Sentence("GLU draws at most {0} slices or stacks", maxOfGlu)) ||
        std::find(form.coords.begin() + 1, form.coords.end(), true) != form.coords.end())
        return false;
    const auto showsAxes = [&](std::size_t pass, std::size_t unit) {
        return std::ranges::any_of(generatedCoordinates, [&](const GeneratedCoordinate& coordinate) {
            const TexGen& generated = scene.passes[pass].units[unit].*coordinate.state;
            const std::string mode = unitPath(pass, unit, {coordinate.key(), keyOf<&TexGen::mode>()});
            return generated.enabled && emission.keys.mayBe(mode, generated.mode, [](TexGenMode is) {
                return is == TexGenMode::ObjectLinear;
            });
        });
    };
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        const std::vector<std::size_t> drawn = drawnModels(scene, scene.passes[p]);
        for (std::size_t u = 0; u < maxUnits && std::ranges::find(drawn, index) != drawn.end(); ++u) {
            if (scene.passes[p].units[u].enabled && showsAxes(p, u))
                return false;
        }
    }
    return true;
}

} // namespace

bool isTurnedForGlu(const Model& model) {
    return model.shape == Shape::Sphere || model.shape == Shape::Cylinder;
}

bool hasQuadrics(const Emission& emission) {
    return std::ranges::find(emission.models, Drawing::Quadric, &ModelForm::drawing) != emission.models.end();
}

void takeGlu(Emission& emission) {
    for (std::size_t i = 0; i < emission.models.size(); ++i) {
        if (isQuadric(emission, i, emission.models[i]))
            emission.models[i].drawing = Drawing::Quadric;
    }
    const auto isGlu = [](const auto& code) { return code && *code && (*code)->mipmaps == MipPolicy::Glu; };
    emission.callsGlu = hasQuadrics(emission) || std::ranges::any_of(emission.texels, isGlu);
}

void writeQuadric(Emission& emission, std::size_t index) {
    CodeWriter& writer = emission.writer;
    const Model& model = emission.scene.models[index];
    const auto path = [&](const std::string& key) {
        return fmt::format("{}.{}", elementOf<&Scene::models>(index), key);
    };
    const auto real = [&](float value, const std::string& key) {
        return number(value, path(key), -1, Literal::Double);
    };
    const Part comma = plain(", ");
    const std::vector<Part> parts{whole(model.slices, path(keyOf<&Model::slices>())), comma,
                                  whole(model.stacks, path(keyOf<&Model::stacks>()))};
    std::string_view name = "gluSphere";
    std::vector<Part> arguments{plain("quadric, ")};
    if (isTurnedForGlu(model))
        writer.add({call("glRotatef"),
                    plain("(-90.0f, 1.0f, 0.0f, 0.0f); "),
                    {Part::Kind::Comment, "/* GLU's z axis becomes y */"}});
    switch (model.shape) {
    case Shape::Sphere:
        append(arguments, {plain("1.0, ")});
        break;
    case Shape::Cylinder:
        writer.add("glTranslatef(0.0f, 0.0f, -1.0f);");
        name = "gluCylinder";
        append(arguments,
               {plain("1.0, "), real(model.topRadius, keyOf<&Model::topRadius>()), plain(", 2.0, ")});
        break;
    default:
        name = model.shape == Shape::Disk ? "gluDisk" : "gluPartialDisk";
        append(arguments, {real(model.innerRadius, keyOf<&Model::innerRadius>()), plain(", 1.0, ")});
    }
    append(arguments, parts);
    if (model.shape == Shape::PartialDisk)
        append(arguments, {comma, real(model.startAngle, keyOf<&Model::startAngle>()), comma,
                           real(model.sweepAngle, keyOf<&Model::sweepAngle>())});
    writer.add(callWith(name, std::move(arguments)));
}

} // namespace texplorer::emit
