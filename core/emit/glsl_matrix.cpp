// Texture matrices as products that shaders are given, for OpenGL 3.3's core profile.

#include "texplorer/emit/glsl_emission.h"
#include "texplorer/emit/transformations.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

class TextureMatrixWriter {
public:
    /// `variable` comes between the pass's and the unit's: which of several it is.
    TextureMatrixWriter(GlslEmission& glsl, const GlslPass& pass, std::size_t unit, std::size_t model,
                        const std::string& variable = {})
        : emission_(glsl.emission)
        , writer_(glsl.emission.writer)
        , pass_(pass)
        , index_(unit)
        , steps_(textureSteps(glsl.emission.scene, pass.index, unit, model))
        , variable_(joined(joined(pass.variable, variable), fmt::format("unit{}Matrix", unit))) {}

    void write() {
        MatrixProduct product(emission_, variable_, true);
        for (std::size_t i = 0; i < steps_.size(); ++i)
            addStep(emission_, product, steps_[i], index_, nameOf(i), true);
        product.finish();
        if (pass_.units[index_]->lateFlip == LateFlip::Matrix) {
            emission_.use(CFunction::FloatProduct);
            writer_.add(
                {plain(fmt::format(
                     "const Matrix {}Flip = {{{{1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1}}}}; ",
                     variable_)),
                 {Part::Kind::Comment, "/* t becomes 1 - t: the image is upside down */"}});
            writer_.add(fmt::format("{0} = multiplyFloats({0}Flip, {0});", variable_));
        }
        emission_.use(CFunction::SetMatrix);
        writer_.add(fmt::format("setMatrix({}, \"textureMatrix{}\", {});", pass_.program, index_, variable_));
    }

private:
    /// What a matrix of numbers is called: by its place among the steps of the pass, or among all.
    [[nodiscard]] std::string nameOf(std::size_t place) const {
        const PlacedStep& placed = steps_[place];
        const bool isPass = placed.pass == pass_.index && !placed.model;
        return isPass ? fmt::format("{}{}", variable_, placed.index)
                      : fmt::format("{}Step{}", variable_, place);
    }

    Emission& emission_;
    CodeWriter& writer_;
    const GlslPass& pass_;
    std::size_t index_;
    PlacedSteps steps_;
    std::string variable_;
};

} // namespace

void writeGlslMatrix(GlslEmission& glsl, const GlslPass& pass, std::size_t unit, MatrixTime time,
                     std::size_t model) {
    const Scene& scene = glsl.emission.scene;
    if (!pass.units[unit] || !pass.uniforms.contains(fmt::format("textureMatrix{}", unit)))
        return;
    const std::vector<std::size_t> models = drawnModels(scene, scene.passes[pass.index]);
    const PlacedSteps first = textureSteps(scene, pass.index, unit, models.front());
    const bool isShared = std::ranges::all_of(
        models, [&](std::size_t each) { return textureSteps(scene, pass.index, unit, each) == first; });
    const MatrixTime own = !isShared                              ? MatrixTime::Model
                           : anyMoves(glsl.emission, first, unit) ? MatrixTime::Frame
                                                                  : MatrixTime::Once;
    if (time != own)
        return;
    if (isShared)
        TextureMatrixWriter(glsl, pass, unit, models.front()).write();
    else
        TextureMatrixWriter(glsl, pass, unit, model, fmt::format("model{}", model)).write();
}

} // namespace texplorer::emit
