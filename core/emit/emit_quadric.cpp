// Spheres, cylinders and disks as GLU draws them.

#include "texplorer/emit/emission.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// GLU gives coordinates to unit 0 alone, and its axis is z, which coordinates of the model's space show.
bool isQuadric(const Scene& scene, std::size_t index, const ModelForm& form) {
    constexpr int maxOfGlu = 239; // Mesa's GLU makes more slices or stacks as many
    const Model& model = scene.models[index];
    if (form.drawing != Drawing::Shape || model.shape == Shape::Torus ||
        std::max(model.slices, model.stacks) > maxOfGlu ||
        std::find(form.coords.begin() + 1, form.coords.end(), true) != form.coords.end())
        return false;
    const auto showsAxes = [](const TexGen& generated) {
        return generated.enabled && generated.mode == TexGenMode::ObjectLinear;
    };
    return std::ranges::none_of(scene.passes, [&](const Pass& pass) {
        const std::vector<std::size_t> drawn = drawnModels(scene, pass);
        return std::ranges::find(drawn, index) != drawn.end() &&
               std::ranges::any_of(pass.units, [&](const Unit& unit) {
                   return unit.enabled && (showsAxes(unit.texGenS) || showsAxes(unit.texGenT) ||
                                           showsAxes(unit.texGenR) || showsAxes(unit.texGenQ));
               });
    });
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
        if (isQuadric(emission.scene, i, emission.models[i]))
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
