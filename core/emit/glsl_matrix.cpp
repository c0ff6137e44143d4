// Texture matrices as products that shaders are given, for OpenGL 3.3's core profile.

#include "texplorer/emit/glsl_emission.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// "0.5f + 0.1f * seconds", a double.
std::vector<Part> atTime(CodeWriter& writer, const Part& start, const Part& rate, bool moves) {
    if (!moves)
        return {start};
    return {start, plain(" + "), rate, plain(" * "), writer.seconds()};
}

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
            addStep(product, i);
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
    [[nodiscard]] std::vector<Part> vector(const MatrixStep& step, const std::string& path) const {
        const std::string amount = fmt::format("{}.{}", path, keyOf<&MatrixStep::amount>());
        const std::string rate = fmt::format("{}.{}", path, keyOf<&MatrixStep::rate>());
        std::vector<Part> parts;
        for (int i = 0; i < 3; ++i) {
            if (i > 0)
                parts.push_back(plain(", "));
            append(parts, atTime(writer_, number(step.amount[i], amount, i), number(step.rate[i], rate, i),
                                 step.rate[i] != 0 || writer_.moves(rate)));
        }
        return parts;
    }

    /// What a matrix of numbers is called: by its place among the steps of the pass, or among all.
    [[nodiscard]] std::string nameOf(std::size_t place) const {
        const PlacedStep& placed = steps_[place];
        const bool isPass = placed.pass == pass_.index && !placed.model;
        return isPass ? fmt::format("{}{}", variable_, placed.index)
                      : fmt::format("{}Step{}", variable_, place);
    }

    void addStep(MatrixProduct& product, std::size_t place) {
        const MatrixStep& step = *steps_[place].step;
        const std::string path = stepPath(steps_[place], index_);
        const auto own = [&](const std::string& key) { return fmt::format("{}.{}", path, key); };
        const auto isSet = [&](const glm::vec3& vector, const std::string& key) {
            return vector != glm::vec3(0) || writer_.moves(own(key));
        };
        std::vector<Part> pivot;
        if (isSet(step.pivot, keyOf<&MatrixStep::pivot>()))
            pivot = numbers({&step.pivot.x, 3}, own(keyOf<&MatrixStep::pivot>()));
        switch (step.op) {
        case MatrixOp::Translate:
            return product.addTranslation(vector(step, path));
        case MatrixOp::Rotate: {
            if (!isSet(step.amount, keyOf<&MatrixStep::amount>()) &&
                !isSet(step.rate, keyOf<&MatrixStep::rate>()))
                return; // no axis: OpenGL leaves it undefined
            const std::string rate = own(keyOf<&MatrixStep::angleRate>());
            return product.addRotation(atTime(writer_, number(step.angle, own(keyOf<&MatrixStep::angle>())),
                                              number(step.angleRate, rate),
                                              step.angleRate != 0 || writer_.moves(rate)),
                                       vector(step, path), pivot);
        }
        case MatrixOp::Scale:
            return product.addScaling(vector(step, path), pivot);
        case MatrixOp::Multiply:
        case MatrixOp::Load: {
            writer_.matrix(fmt::format("const Matrix {} = {{{{", nameOf(place)),
                           numbers({glm::value_ptr(step.matrix), 16},
                                   fmt::format("{}.{}", path, keyOf<&MatrixStep::matrix>())),
                           "}};");
            return product.add({plain(nameOf(place))});
        }
        case MatrixOp::Projector:
            return addProjector(product, nameOf(place));
        }
    }

    /// From eye coordinates to the light's picture, from 0 to 1: as the light is, so it stays.
    void addProjector(MatrixProduct& product, const std::string& name) {
        const glm::dmat4 matrix =
            emission_.keys.decided(emission_.scene, lightPaths(), [](const Scene& scene) {
                constexpr glm::dmat4 toPicture{
                    {0.5, 0, 0, 0}, {0, 0.5, 0, 0}, {0, 0, 0.5, 0}, {0.5, 0.5, 0.5, 1}};
                const LightView light = texplorer::lightView(scene.light);
                return toPicture * light.projection * light.view;
            });
        writer_.comment("from eye coordinates to the light's picture");
        writer_.matrix(fmt::format("const Matrix {} = {{{{", name), doubles(matrix), "}};");
        product.add({plain(name)});
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

void MatrixProduct::add(std::vector<Part> term) {
    emission_.use(CFunction::Matrices);
    std::vector<Part> parts;
    if (isEmpty_)
        parts.push_back(plain(fmt::format("{}{} = ", declares_ ? "Matrix " : "", variable_)));
    else
        parts.push_back(plain(fmt::format("{0} = multiply({0}, ", variable_)));
    append(parts, std::move(term));
    parts.push_back(plain(isEmpty_ ? ";" : ");"));
    emission_.writer.add(std::move(parts));
    isEmpty_ = false;
}

void MatrixProduct::addTranslation(std::vector<Part> offset) {
    emission_.use(CFunction::Translation);
    std::vector<Part> parts{plain("translation(")};
    append(parts, std::move(offset));
    parts.push_back(plain(")"));
    add(std::move(parts));
}

void MatrixProduct::addRotation(std::vector<Part> angle, std::vector<Part> axis,
                                const std::vector<Part>& pivot) {
    emission_.use(CFunction::Rotation);
    std::vector<Part> parts{plain("rotation(")};
    append(parts, std::move(angle));
    parts.push_back(plain(", "));
    append(parts, std::move(axis));
    parts.push_back(plain(")"));
    addAbout(std::move(parts), pivot);
}

void MatrixProduct::addScaling(std::vector<Part> factors, const std::vector<Part>& pivot) {
    emission_.use(CFunction::Scaling);
    std::vector<Part> parts{plain("scaling(")};
    append(parts, std::move(factors));
    parts.push_back(plain(")"));
    addAbout(std::move(parts), pivot);
}

void MatrixProduct::addAbout(std::vector<Part> term, const std::vector<Part>& pivot) {
    if (pivot.empty())
        return add(std::move(term));
    emission_.use(CFunction::About);
    std::vector<Part> parts{plain("about(")};
    append(parts, pivot);
    parts.push_back(plain(", "));
    append(parts, std::move(term));
    parts.push_back(plain(")"));
    add(std::move(parts));
}

void MatrixProduct::finish() {
    if (!isEmpty_)
        return;
    emission_.use(CFunction::Identity);
    add({plain("identity")});
}

} // namespace texplorer::emit
