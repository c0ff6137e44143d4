// make_corpus FOLDER: the start corpus of the fuzzers, written by our own writers if there are any. One
// subfolder per fuzzer; those of the decoders have the names of their rows, so that a new row adds its own.

#include "tests/support/sample_jpegs.h"
#include "tests/support/sample_textures.h"
#include "texplorer/files/file_io.h"
#include "texplorer/gl/transfer.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/suite/record_json.h"
#include "texplorer/suite/shard.h"

#include <cstdio>
#include <filesystem>
#include <set>

namespace {

using namespace texplorer;

bool write(const std::filesystem::path& folder, const std::string& name, ByteView bytes) {
    const Result<void> done = writeFileAtomically(folder / name, bytes);
    if (!done)
        std::fprintf(stderr, "make_corpus: %s\n", describe(done.error()).english().c_str());
    return done.has_value();
}

bool writeAll(const std::filesystem::path& folder, std::string_view prefix, const std::vector<Bytes>& files) {
    bool good = true;
    for (std::size_t i = 0; i < files.size(); ++i)
        good = write(folder, std::string(prefix) + std::to_string(i), files[i]) && good;
    return good;
}

std::vector<Bytes> filesFor(const CodecRow& row) {
    return row.name == "JPEG" ? test::sampleJpegs() : test::sampleFiles(row);
}

/// Every enumerator and every parameter occurs at least once.
std::vector<Scene> sampleScenes() {
    Scene full = defaultScene();
    full.textures.resize(2);
    full.textures[1].source = SourceKind::File;
    full.textures[1].file = "wood.bmp";
    for (Unit& unit : full.passes.front().units)
        unit.matrix.resize(1);
    Scene small;
    Model quad;
    quad.shape = Shape::Quad;
    quad.texCoords[0] = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};
    small.models = {quad};
    return {defaultScene(), full, small};
}

/// A suite and its results: a report, a journal and durations.
std::vector<std::string> sampleSuites() {
    suite::RunRecord run;
    run.suites = {"s"};
    run.names = {"a/fixed@8x8", "b/fixed@8x8"};
    run.cases = {{.name = run.names[0], .state = suite::State::Failed}};
    run.cases[0].metric = "absolute";
    run.cases[0].worst.emplace();
    run.cases[0].golden = run.cases[0].actualPicture = "a.png";
    return {
        R"({"suite": 1, "name": "n", "defaults": {"size": ["8x8"], "golden": "reference", "rule": "auto"}, "cases": [
  {"scene": {"example": "checker"}, "axis": "textures[0].wrapS=*", "renderer": ["fixed", "shader"], "time": [0, 1]},
  {"scene": {"lesson": "wrap", "step": 3, "reached": true}, "set": ["preset:seam", "view.azimuth=3"], "seconds": 1},
  {"scene": {"inline": {"version": 1}}, "golden": {"*": ["g/{case}.png", "{picture}.png"], "llvmpipe*": "{driver}.png"},
   "metric": "ssim", "tolerance": 0.25, "share": 0.125, "mask": "m.png"}]})",
        suite::asJson(run), suite::journalStart(run) + suite::journalLine(run.cases[0]),
        suite::writeDurations({{"a", 1}})};
}

/// A libFuzzer dictionary: the words of the parameter tables, which random input would hardly contain.
std::string dictionary(const Scene& scene) {
    std::set<std::string> words{"true", "false", "1e38", "-0", "version"};
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value&) {
        words.insert(path);
        words.emplace(row.key);
        for (const EnumRow& choice : row.choices)
            words.emplace(choice.name);
    });
    std::string text;
    for (const std::string& word : words)
        text += '"' + word + "\"\n";
    return text;
}

bool makeCorpus(const std::filesystem::path& folder) {
    std::error_code error; // a missing folder is reported when a file is written
    for (const CodecRow& row : codecRows())
        std::filesystem::create_directories(folder / row.name, error);
    for (const std::string_view name : {"codecs", "flip", "obj", "param", "scene", "suite", "upload"})
        std::filesystem::create_directories(folder / name, error);
    bool good = true;
    for (const CodecRow& row : codecRows())
        good = writeAll(folder / row.name, "", filesFor(row)) &&
               writeAll(folder / "codecs", row.name, filesFor(row)) && good;
    for (std::size_t format = 0; format < blockFormatRows.size(); ++format) // see fuzz_flip.cpp
        for (const auto& [flip, width, height] :
             {std::tuple{0, 8, 12}, {1, 2, 4}, {2, 64, 1}, {2, 3, 3}, {0, 4, 6}}) {
            std::string input{char(format), char(flip), char(width - 1), char(height - 1), char(format % 2)};
            input += "sixteen bytes of a block";
            const std::string name =
                std::to_string(format) + "-" + std::to_string(flip) + "-" + std::to_string(height);
            good = write(folder / "flip", name, viewBytes(input)) && good;
        }
    good =
        write(folder / "obj", "0",
              viewBytes("mtllib a.mtl\nv 0 0 0\nv 1 0 0 1\nv 1e1 -1.5 0\nvt 0 1\nvn 0 0 1\no a b\nusemtl m\n"
                        "f 1/1/1 2//1 3/1 1\nf -1 -2 -3\ng c\nl 1 2\nnewmtl m\nKd 1 0.5 0\nd 0.5\n"
                        "map_Kd -s 1 2 3 a\\b.png\n")) &&
        good;
    for (std::size_t type = 0; type < transferTypeRows.size(); ++type) { // see fuzz_upload.cpp
        std::string input{
            char(type % transferFormatRows.size()), char(type), 4, char(type % 2), 0, 0, 1, 3, 2, 0};
        input += "the bytes of some pixels in memory";
        good = write(folder / "upload", std::to_string(type), viewBytes(input)) && good;
    }
    const std::vector<Scene> scenes = sampleScenes();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        good = write(folder / "scene", std::to_string(i), viewBytes(writeScene(scenes[i]))) && good;
        std::string lines;
        forEachParam(scenes[i], [&](const std::string& path, const ParamRow& row, const Value& value) {
            const std::string line = path + "=" + formatValue(row, value) + "\n";
            if (row.kind == Kind::Enum || lines.size() < 512)
                lines += line;
        });
        good = write(folder / "param", std::to_string(i), viewBytes(lines)) && good;
    }
    const std::vector<std::string> suites = sampleSuites();
    for (std::size_t i = 0; i < suites.size(); ++i)
        good = write(folder / "suite", std::to_string(i), viewBytes(suites[i])) && good;
    return write(folder, "words.dict", viewBytes(dictionary(scenes[1]))) && good;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: make_corpus FOLDER\n");
        return 2;
    }
    return makeCorpus(arguments[1]) ? 0 : 1;
}
