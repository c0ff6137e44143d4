// Texture matrices: steps that collapse coordinates or change nothing, and the stacks of the units.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/texture_matrix.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace texplorer::diagnosis {
namespace {

/// The depth of the stacks that every OpenGL has (OpenGL 2.1, section 6.2: GL_MAX_TEXTURE_STACK_DEPTH).
constexpr int guaranteedDepth = 2;

/// Steps of a pass, or of a model that some pass draws.
struct StepList {
    const std::vector<MatrixStep>& steps;
    std::string path; ///< of the list
    int axes;         ///< that textures look at; 0: no unit with these steps is on

    [[nodiscard]] std::string at(std::size_t index) const { return fmt::format("{}[{}]", path, index); }
};

std::string modelUnitPath(std::size_t model, std::size_t unit) {
    return fmt::format("{}.{}", elementOf<&Scene::models>(model), elementOf<&Model::units>(unit));
}

/// How many coordinates the textures of a unit that is on look at, in the passes that draw a model.
int axesOfModel(const Scene& scene, std::size_t model, std::size_t unit) {
    int axes = 0;
    for (const Pass& pass : scene.passes) {
        const std::vector<std::size_t> drawn = drawnModels(scene, pass);
        if (pass.units[unit].enabled && std::ranges::find(drawn, model) != drawn.end())
            axes = std::max(axes, coordinatesOf(pass.units[unit].target));
    }
    return axes;
}

template<class Visit> ///< visit(list), for passes and models that are drawn
void forEachList(const Scene& scene, Visit visit) {
    forEachUnit(scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        visit(StepList{unit.matrix, path + keyOf<&Unit::matrix>(),
                       unit.enabled ? coordinatesOf(unit.target) : 0});
    });
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        for (std::size_t u = 0; u < maxUnits && isDrawn(scene, m); ++u)
            visit(StepList{scene.models[m].units[u].matrix,
                           fmt::format("{}.{}", modelUnitPath(m, u), keyOf<&ModelUnit::matrix>()),
                           axesOfModel(scene, m, u)});
    }
}

void collapsingMatrix(const Case& about, Report& report) {
    constexpr std::string_view letters = "str";
    forEachList(about.scene, [&](const StepList& list) {
        for (std::size_t i = 0; i < list.steps.size() && list.axes > 0; ++i) {
            const MatrixStep& step = list.steps[i];
            const std::string amount = fmt::format("{}.{}", list.at(i), keyOf<&MatrixStep::amount>());
            if (step.op == MatrixOp::Rotate && step.amount == glm::vec3(0) && step.rate == glm::vec3(0))
                report.add(amount, N_("the axis has length 0: the rotation is undefined in OpenGL"),
                           Fix{N_("Rotate about r"), {{amount, "0,0,1"}}});
            if (step.op != MatrixOp::Scale)
                continue;
            std::vector<Sentence> collapsed;
            std::string factors;
            for (int axis = 0; axis < 3; ++axis) {
                const bool zero = step.amount[axis] == 0 && step.rate[axis] == 0;
                if (zero && axis < list.axes)
                    collapsed.emplace_back(ProperName{letters.substr(static_cast<std::size_t>(axis), 1)});
                factors += (axis > 0 ? "," : "") + std::string(zero ? "1" : formatNumber(step.amount[axis]));
            }
            if (!collapsed.empty())
                report.add(
                    amount,
                    Sentence(
                        "a scale of 0 gives all vertices the same {0}: the image shrinks to a line or a texel",
                        Sentence::joined("{0} and {1}", collapsed)),
                    Fix{N_("Scale by 1"), {{amount, factors}}});
        }
    });
}

/// glLoadMatrix puts its matrix in the place of all that was made before.
void replacedSteps(const Case& about, Report& report) {
    forEachList(about.scene, [&](const StepList& list) {
        for (std::size_t last = list.steps.size(); last-- > 1;) {
            if (list.steps[last].op != MatrixOp::Load)
                continue;
            for (std::size_t i = 0; i < last; ++i)
                report.add(list.at(i), Sentence("step {0} loads another matrix instead", last + 1));
            break;
        }
    });
}

/// A parameter of a step, and the operations that read it.
struct OperationRow {
    Key key;
    std::span<const MatrixOp> operations;
};
constexpr std::array amounts{MatrixOp::Translate, MatrixOp::Rotate, MatrixOp::Scale};
constexpr std::array angles{MatrixOp::Rotate};
constexpr std::array pivots{MatrixOp::Rotate, MatrixOp::Scale};
constexpr std::array matrices{MatrixOp::Multiply, MatrixOp::Load};
constexpr std::array operationRows{
    OperationRow{keyOf<&MatrixStep::amount>, amounts}, OperationRow{keyOf<&MatrixStep::rate>, amounts},
    OperationRow{keyOf<&MatrixStep::angle>, angles},   OperationRow{keyOf<&MatrixStep::angleRate>, angles},
    OperationRow{keyOf<&MatrixStep::pivot>, pivots},   OperationRow{keyOf<&MatrixStep::matrix>, matrices},
};

void otherOperation(const Case& about, Report& report) {
    forEachList(about.scene, [&](const StepList& list) {
        for (std::size_t i = 0; i < list.steps.size(); ++i) {
            for (const OperationRow& row : operationRows) {
                if (std::ranges::find(row.operations, list.steps[i].op) != row.operations.end())
                    continue;
                std::vector<Sentence> readers;
                for (const MatrixOp op : row.operations)
                    readers.push_back(named(op));
                report.add(fmt::format("{}.{}", list.at(i), row.key()),
                           Sentence("only these steps read it: {0}", Sentence::joined("{0}, {1}", readers)));
            }
        }
    });
}

template<class Visit> ///< visit(pass, unit, model), of units that are on and models that are drawn with them
void forEachMatrix(const Scene& scene, Visit visit) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (const std::size_t model : drawnModels(scene, scene.passes[p])) {
            for (std::size_t u = 0; u < maxUnits; ++u) {
                if (scene.passes[p].units[u].enabled)
                    visit(p, u, model);
            }
        }
    }
}

/// The models whose steps other models are drawn with, or later passes.
void forgottenPop(const Case& about, Report& report) {
    std::vector<std::set<std::size_t>> changed(about.scene.models.size()); // by each model
    forEachMatrix(about.scene, [&](std::size_t pass, std::size_t unit, std::size_t model) {
        for (const PlacedStep& placed : textureSteps(about.scene, pass, unit, model)) {
            if (placed.model && (placed.model != model || placed.pass != pass))
                changed[*placed.model].insert(model);
        }
    });
    for (std::size_t m = 0; m < changed.size(); ++m) {
        if (changed[m].empty())
            continue;
        std::vector<Sentence> names;
        for (const std::size_t model : changed[m])
            names.emplace_back(ProperName{elementOf<&Scene::models>(model)});
        const std::string path =
            fmt::format("{}.{}", elementOf<&Scene::models>(m), keyOf<&Model::pushMatrix>());
        report.add(path,
                   Sentence("without glPopMatrix the texture matrix steps of {0} also change what is drawn "
                            "later: {1}",
                            ProperName{elementOf<&Scene::models>(m)}, Sentence::joined("{0}, {1}", names)),
                   Fix{N_("Push and pop the matrix"), {{path, "true"}}});
    }
}

void stackDepth(const Case& about, Report& report) {
    std::set<std::string> said;
    forEachMatrix(about.scene, [&](std::size_t pass, std::size_t unit, std::size_t m) {
        const Model& model = about.scene.models[m];
        const bool pushes = about.scene.passes[pass].units[unit].matrixStart == MatrixStart::Push;
        const bool pushesAgain = model.pushMatrix && !model.units[unit].matrix.empty();
        const int depth = 1 + int{pushes} + int{pushesAgain};
        const std::string path = unitPath(pass, unit) + keyOf<&Unit::matrixStart>();
        if (depth <= guaranteedDepth || !said.insert(path).second)
            return;
        std::vector<Fix> fixes;
        if (!isLeftMatrixRead(about.scene, pass, unit))
            fixes = {{N_("Don't push: no later pass needs it"), {{path, nameOf(MatrixStart::Keep)}}}};
        report.add(path,
                   Sentence("this pass and models[{0}] both push the matrix: that needs a stack of {1}, and "
                            "OpenGL guarantees {2} (GL_MAX_TEXTURE_STACK_DEPTH)",
                            m, depth, guaranteedDepth),
                   std::move(fixes));
    });
}

void noStart(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t p) {
        const auto u = static_cast<std::size_t>(&unit - about.scene.passes[p].units.data());
        if (unit.enabled && leftSteps(about.scene, p, u).empty() && !isLeftMatrixRead(about.scene, p, u))
            report.add(path + keyOf<&Unit::matrixStart>(),
                       N_("no earlier pass leaves a matrix, and later ones begin with the identity"));
    });
}

void noOwnSteps(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        const Model& model = about.scene.models[m];
        if (!isDrawn(about.scene, m))
            continue;
        bool has = false;
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (model.units[u].matrix.empty())
                continue;
            const bool isOn = axesOfModel(about.scene, m, u) > 0;
            has |= isOn;
            if (!isOn)
                report.add(modelUnitPath(m, u), N_("the unit is off in all passes that draw the model"));
        }
        if (!has)
            report.add(fmt::format("{}.{}", elementOf<&Scene::models>(m), keyOf<&Model::pushMatrix>()),
                       N_("the model has no steps of its own for a unit that is on"));
    }
}

constexpr std::array matrixRuleRows{
    Rule{"collapsing-matrix", Severity::Warning, collapsingMatrix},
    Rule{"forgotten-pop", Severity::Warning, forgottenPop},
    Rule{"matrix-stack-depth", Severity::Warning, stackDepth},
    Rule{"matrix-replaced", Severity::Hint, replacedSteps},
    Rule{"matrix-start", Severity::Hint, noStart},
    Rule{"model-steps", Severity::Hint, noOwnSteps},
    Rule{"other-matrix-operation", Severity::Unused, otherOperation},
};

} // namespace

bool hasMatrix(const Scene& scene, std::size_t pass, std::size_t unit) {
    return std::ranges::any_of(drawnModels(scene, scene.passes[pass]), [&](std::size_t model) {
        return !textureSteps(scene, pass, unit, model).empty();
    });
}

bool isLeftMatrixRead(const Scene& scene, std::size_t pass, std::size_t unit) {
    for (std::size_t p = pass + 1; p < scene.passes.size(); ++p) {
        const Unit& later = scene.passes[p].units[unit];
        if (scene.passes[p].enabled && scene.passes[p].picture == scene.passes[pass].picture && later.enabled)
            return later.matrixStart != MatrixStart::Identity;
    }
    return false;
}

std::span<const Rule> matrixRules() {
    return matrixRuleRows;
}

} // namespace texplorer::diagnosis
