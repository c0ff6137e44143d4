// Tests that the driver does not crash: draws every kind of texture with both OpenGL renderers, in child
// processes that are restarted if one of them ends by a signal. A child is forked before anything here has
// used OpenGL. Combines a few values of each setting; --all takes more.

#include "app/offscreen/context.h"
#include "app/render/shader_renderer.h"
#include "tests/support/flat_scene.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/texture/image_source.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using namespace texplorer;

template<class E>
constexpr std::span<const EnumRow> rows = EnumTable<E>::rows;

struct Case {
    std::string name;
    Scene scene;
};

/// A surface with a gradient in each coordinate, that minifies on one side. The unit has a bias, the texture
/// may have one, too.
Scene drawnScene(Target target, const Texture& texture, float bias) {
    Scene scene = test::texturedScene();
    scene.textures[0] = texture;
    Unit& unit = scene.passes[0].units[0];
    unit.target = target;
    unit.lodBias = bias;
    scene.models[0].texCoords[0] = test::quadCoords({-0.3F, -1, 0.1F, 1}, {9, 1.5F, 0.7F, 1.5F});
    return scene;
}

std::string describe(Target target, const Texture& texture, float bias) {
    return std::string(rowOf(target).name) + " " + std::string(rowOf(texture.mipmaps).name) + " " +
           std::string(rowOf(texture.minFilter).name) + " " + std::string(rowOf(texture.magFilter).name) +
           " " + std::string(rowOf(texture.wrapS).name) + " anisotropy " +
           std::to_string(texture.maxAnisotropy) + " biases " + std::to_string(texture.lodBias) + " and " +
           std::to_string(bias) + " levels " + std::to_string(texture.baseLevel) + " to " +
           std::to_string(texture.maxLevel);
}

/// target x levels x filters x anisotropy x biases; the wrap modes alternate, because all of them would be
/// too many.
std::vector<Case> filterCases(bool all) {
    const std::vector<float> anisotropies =
        all ? std::vector<float>{1, 1.5F, 2, 4, 16} : std::vector<float>{4};
    using Biases = std::pair<float, float>; // of the texture and of the unit
    const std::vector<Biases> biases = all ? std::vector<Biases>{{0, 0},  {0, -6.49F}, {0, -0.3F}, {0, 3.5F},
                                                                 {0, 16}, {-6.49F, 0}, {16, -0.3F}}
                                           : std::vector<Biases>{{0, 0}, {0, -6.49F}, {-6.49F, 0}};
    const auto rounds = all ? rows<Wrap>.size() : 1;
    std::vector<Case> cases;
    for (std::size_t round = 0; round < rounds; ++round)
        for (const EnumRow& target : rows<Target>)
            for (const MipPolicy mipmaps : {MipPolicy::None, MipPolicy::Generated})
                for (const EnumRow& min : rows<MinFilter>)
                    for (const EnumRow& mag : rows<MagFilter>)
                        for (const float anisotropy : anisotropies)
                            for (const auto& [ofTexture, bias] : biases) {
                                Texture texture;
                                texture.lodBias = ofTexture;
                                texture.mipmaps = mipmaps;
                                texture.minFilter = static_cast<MinFilter>(min.value);
                                texture.magFilter = static_cast<MagFilter>(mag.value);
                                const EnumRow& wrap = rows<Wrap>[(cases.size() + round) % rows<Wrap>.size()];
                                texture.wrapS = texture.wrapT = texture.wrapR = static_cast<Wrap>(wrap.value);
                                texture.maxAnisotropy = anisotropy;
                                // Complete with any filter, with one level.
                                texture.maxLevel = mipmaps == MipPolicy::None ? 0 : 1000;
                                const auto where = static_cast<Target>(target.value);
                                cases.push_back(
                                    {describe(where, texture, bias), drawnScene(where, texture, bias)});
                            }
    return cases;
}

/// Existing and missing levels.
std::vector<Case> levelCases(bool all) {
    constexpr std::array levels{-1, 0, 1, 2, 5, 6, 7, 14, 15, 16, 200, 250, 322, 1000, 100000};
    std::mt19937 dice(1);
    const auto below = [&](std::size_t end) { return static_cast<std::size_t>(dice() % end); };
    const auto any = [&]<class E>(E) { return static_cast<E>(rows<E>[below(rows<E>.size())].value); };
    std::vector<Case> cases;
    for (int i = 0; i < (all ? 3000 : 150); ++i) {
        Texture texture;
        texture.pattern = any(Pattern{});
        texture.mipmaps = any(MipPolicy{});
        texture.minFilter = any(MinFilter{});
        texture.magFilter = any(MagFilter{});
        texture.wrapS = any(Wrap{});
        texture.baseLevel = levels[below(levels.size())];
        texture.maxLevel = levels[below(levels.size())];
        texture.minLod = static_cast<float>(below(2000)) - 1000;
        texture.maxLod = static_cast<float>(below(2000)) - 1000;
        texture.maxAnisotropy = below(2) == 0 ? 1 : 16;
        texture.lodBias = below(2) == 0 ? 0 : static_cast<float>(below(40)) - 20;
        const Target target = any(Target{});
        const float bias = static_cast<float>(below(40)) - 20;
        cases.push_back({describe(target, texture, bias), drawnScene(target, texture, bias)});
    }
    return cases;
}

/// Coordinates that run fast, or without end because q runs through 0.
std::vector<Case> footprintCases() {
    const auto generated = [](TexGenMode mode) {
        return [mode](Scene& scene) {
            scene.passes[0].units[0].texGenQ = {
                .enabled = true, .mode = mode, .objectPlane = {1, 0, 0, 0}, .eyePlane = {1, 0, 0, 0}};
        };
    };
    struct Spoiled {
        const char* name;
        std::function<void(Scene&)> spoil;
    };
    const std::array ways{
        Spoiled{"q of vertices", [](Scene& scene) { scene.models[0].texCoords[0].edit()[0].q = -1; }},
        Spoiled{"q near 0", [](Scene& scene) { scene.models[0].texCoords[0].edit()[0].q = 1e-6F; }},
        Spoiled{"q of the object", generated(TexGenMode::ObjectLinear)},
        Spoiled{"q of the eye", generated(TexGenMode::EyeLinear)},
        Spoiled{"q of a matrix",
                [](Scene& scene) {
                    MatrixStep step{.op = MatrixOp::Multiply};
                    step.matrix[0].w = 1;
                    step.matrix[3].w = -0.4F;
                    scene.passes[0].units[0].matrix = {step};
                }},
        Spoiled{"1000 repeats",
                [](Scene& scene) {
                    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Scale, .amount = {1000, 1000, 1000}}};
                }},
        Spoiled{"1000 repeats of generated coordinates",
                [](Scene& scene) {
                    Unit& unit = scene.passes[0].units[0];
                    unit.texGenS = unit.texGenT = {
                        .enabled = true, .mode = TexGenMode::ObjectLinear, .objectPlane = {1000, 300, 0, 0}};
                }},
    };
    std::vector<Case> cases;
    for (const EnumRow& target : rows<Target>) {
        for (const MinFilter filter : {MinFilter::Linear, MinFilter::LinearMipmapLinear}) {
            for (const Spoiled& each : ways) {
                Texture texture;
                texture.mipmaps = MipPolicy::Generated;
                texture.minFilter = filter;
                texture.maxAnisotropy = 16;
                const auto where = static_cast<Target>(target.value);
                Scene scene = drawnScene(where, texture, 0);
                each.spoil(scene);
                cases.push_back({describe(where, texture, 0) + ", " + each.name, scene});
            }
        }
    }
    return cases;
}

/// Draws the cases from `first` on in a child; writes the index of each before drawing it.
[[noreturn]] void drawFrom(std::span<const Case> cases, std::size_t first, std::size_t last, int progress) {
    constexpr view::Size size{48, 48};
    const auto context = offscreen::Context::create({1, 1});
    const auto capabilities = context ? render::loadCapabilities() : fail(context.error());
    if (!capabilities) {
        std::fprintf(stderr, "%s\n", texplorer::describe(capabilities.error()).english().c_str());
        _exit(1);
    }
    auto fixed = render::createRenderer(RendererKind::Fixed, *capabilities);
    auto shader = render::createRenderer(RendererKind::Shader, *capabilities);
    if (!fixed || !shader)
        _exit(1);
    const ImageSource images;
    for (std::size_t i = first; i < last; ++i) {
        for (render::SceneRenderer* renderer : {&*fixed, &*shader}) {
            alarm(300); // against a drawing that never ends
            const auto mark = static_cast<unsigned>(2 * i + (renderer == &*shader ? 1 : 0));
            if (write(progress, &mark, sizeof mark) != sizeof mark ||
                !renderer->draw(cases[i].scene, images, 0, size) || !renderer->read())
                _exit(1);
        }
    }
    _exit(0);
}

/// The number of cases that crashed a child.
int countDeaths(std::span<const Case> cases) {
    constexpr std::size_t batch = 64; // otherwise the shaders of a long-running child would fill the memory
    int deaths = 0;
    for (std::size_t first = 0; first < cases.size();) {
        const std::size_t last = std::min(cases.size(), first + batch);
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0)
            return deaths + 1;
        const pid_t child = fork();
        if (child == 0) {
            close(ends[0]);
            drawFrom(cases, first, last, ends[1]);
        }
        close(ends[1]);
        auto mark = static_cast<unsigned>(2 * first);
        for (unsigned found = 0; read(ends[0], &found, sizeof found) == sizeof found;)
            mark = found;
        close(ends[0]);
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child)
            return deaths + 1;
        if (status == 0) {
            first = last;
            continue;
        }
        ++deaths;
        std::fprintf(stderr, "%s %d: %s, %s\n", WIFSIGNALED(status) ? "signal" : "status",
                     WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status),
                     mark % 2 == 0 ? "fixed function" : "shaders", cases[mark / 2].name.c_str());
        first = mark / 2 + 1;
    }
    return deaths;
}

} // namespace

int main(int argc, char** argv) {
    const bool all = argc > 1 && std::string_view(argv[1]) == "--all";
    int deaths = 0;
    for (const std::vector<Case>& cases : {filterCases(all), levelCases(all), footprintCases()}) {
        const int died = countDeaths(cases);
        std::printf("%zu scenes with two renderers: %d not survived\n", cases.size(), died);
        deaths += died;
    }
    return deaths == 0 ? 0 : 1;
}
