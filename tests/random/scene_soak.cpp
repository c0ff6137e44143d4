#include "tests/random/scene_soak.h"

#include "tests/random/odd_files.h"
#include "tests/random/random_scene.h"
#include "tests/random/trial.h"
#include "texplorer/emit/program.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/keys.h"

#include <stdexcept>

namespace texplorer::random {

namespace {

constexpr int batchSize = 25;

void check(const Result<void>& written) {
    if (!written)
        throw std::runtime_error(describe(written.error()));
}

/// The scenes of a batch share a process, and with it what Mesa was asked for.
Precision precisionOf(int number) {
    return number / batchSize % 2 == 0 ? Precision::Exact : Precision::Usual;
}

/// Leaves out key frames of what a program can't move, as shapes: hardly a scene would have a program.
void keepMovable(Scene& scene) {
    emit::TextureCodes codes;
    for (bool isTried = false; !isTried;) {
        const auto program = emit::program(emit::Flavour::Fixed, scene, {}, {}, codes);
        const auto isRefused = [&](const KeyFrame& key) { return key.path == program.error().where; };
        isTried = program || std::erase_if(scene.timeline.keys, isRefused) == 0;
    }
}

} // namespace

Subject randomScenes(const SceneSoak& soak) {
    const std::vector<OddFile> files = oddFiles();
    std::filesystem::create_directories(soak.keep);
    for (const OddFile& file : files)
        check(writeFileAtomically(soak.keep / file.name, file.bytes));
    const auto sceneOf = [seed = soak.seed, oddNames = namesOf(files)](int number) {
        return randomScene(seed, number, oddNames);
    };
    Subject subject;
    subject.one = "scene";
    subject.many = "random scenes";
    subject.arguments = "scenes --seed " + std::to_string(soak.seed) +
                        (soak.shaders.empty() ? "" : " --shaders " + soak.shaders.string());
    subject.batch = batchSize;
    subject.memoryLimit = 8ULL << 30;
    subject.open = [soak, sceneOf](int first) -> Work {
        Result<Trial> trial = Trial::open(precisionOf(first), soak.keep, soak.shaders);
        if (!trial)
            throw std::runtime_error(describe(trial.error()));
        return [sceneOf, trial = std::make_shared<Trial>(std::move(*trial))](int number, Journal& journal) {
            trial->run(sceneOf(number), journal);
        };
    };
    subject.keep = [soak, sceneOf](int number) {
        check(writeFileAtomically(soak.keep / ("scene-" + std::to_string(number) + ".json"),
                                  viewBytes(writeScene(sceneOf(number).scene))));
    };
    return subject;
}

Result<void> writeScenes(const SceneFiles& files) {
    const Temper wildest = files.tame ? Temper::Ordinary : Temper::Wild;
    int written = 0;
    for (int number = 0; written < files.count; ++number) {
        RandomScene random = randomScene(files.seed, number, {});
        if (random.temper > wildest)
            continue;
        if (files.tame) {
            std::erase_if(random.scene.timeline.keys, [](const KeyFrame& key) {
                return key.path.ends_with(keyOf<&Texture::maxAnisotropy>());
            });
            keepMovable(random.scene);
            leaveQ(random.scene);
            for (Texture& texture : random.scene.textures) {
                texture.maxAnisotropy = 1;
                texture.border = std::min(texture.border, 1); // OpenGL refuses others, which ends a program
                if (isRefused(texture.internalFormat))
                    texture.internalFormat = internalFormat(baseFormat(texture.internalFormat));
                if (texture.mipmaps == MipPolicy::Glu) // which rounds in its own way
                    texture.mipmaps = MipPolicy::Generated;
            }
        }
        const std::filesystem::path file =
            std::filesystem::path(files.folder) / ("scene-" + std::to_string(number) + ".json");
        if (const auto done = writeFileAtomically(file, viewBytes(writeScene(random.scene))); !done)
            return done;
        ++written;
    }
    return {};
}

} // namespace texplorer::random
