// What --help and the manual say of each command beside its options: calls that can be made as they stand,
// what
// --json prints, and how a suite is written.

#include "app/screenshot/commands/all_commands.h"

#include <algorithm>
#include <string_view>

namespace texplorer::screenshot {
namespace {

struct CommandExamples {
    std::string_view command;
    std::vector<std::string> lines;
};

/// Run one after the other in an empty folder by tests/end_to_end/texshot/examples_test.py.
const std::vector<CommandExamples>& commandExamples() {
    static const std::vector<CommandExamples> rows{
        {"shot",
         {"texshot shot --example teapot --size 640x480 -o teapot.png",
          "texshot shot --set 'textures[0].minFilter=GL_NEAREST' -o nearest.png",
          "texshot shot --lesson wrap --axis 'textures[0].wrapS=*' -o '{wrapS}.png'",
          "texshot shot --ui --tab explain --probe 400,200 -o window.png"}},
        {"sweep",
         {"texshot sweep --lesson wrap --axis 'textures[0].wrapS=*' -o wrap.png",
          "texshot sweep --axis 'textures[0].minFilter=*' --labels words -o min.png",
          "texshot sweep --axis 'view.azimuth=0..315/8' --difference first -o turn.png",
          "texshot sweep --lesson wrap --axis 'textures[0].wrapS=*' -o '{wrapS}.png'"}},
        {"animate",
         {"texshot animate --set view.distance=9..4..9 --seconds 2 -o near.webp",
          "texshot animate --set view.azimuth=0..360 --seconds 2 -o turn.gif",
          "texshot animate --set 'textures[0].magFilter=*' --seconds 2 --fps 1 -o f.png",
          "texshot animate --set view.roll=0..90 --seconds 1 --fps 8 -o frame-%04d.png"}},
        {"probe",
         {"texshot probe --at 400,400", "texshot probe --example checker --at 300,300 --json",
          "texshot probe --texel 0,3,2,1 --size 320x200"}},
        {"texture",
         {"texshot texture --example cube -o base.png",
          "texshot texture --example earth --level 2 -o small.png",
          "texshot texture --example cube --all-levels -o base.dds"}},
        {"emit",
         {"texshot emit --example cube -o cube.c", "texshot emit --lesson filters --step 3 -o filters.c"}},
        {"commands", {"texshot commands", "texshot commands --example fog --all"}},
        {"test",
         {R"(echo '{"suite": 1, "cases": [{"scene": {"example": "cube"}}]}' > my.suite.json)",
          "texshot test my.suite.json --update", "texshot test my.suite.json --report out",
          "texshot test --pictures golden golden --tolerance 2"}},
        {"merge",
         {R"(echo '{"suite":1,"cases":[{"golden":"reference","time":[0,1]}]}' >s.suite.json)",
          "texshot test s.suite.json --shard 1/2 --report part1",
          "texshot test s.suite.json --shard 2/2 --report part2",
          "texshot merge part* -o run.json --report all"}},
        {"compare",
         {"texshot shot -o a.png; texshot shot --renderer shader -o b.png",
          "texshot compare a.png b.png --tolerance 2 --share 1% -o where.png",
          "texshot compare a.png b.png --metric flip --json"}},
        {"conform",
         {"texshot conform --list", "texshot conform --feature wrap --scenes 10",
          "texshot conform --feature fog --scenes 5 --seed 2 -o report"}},
        {"diff",
         {"texshot scene -o before.json", "texshot scene --set view.distance=9 -o after.json",
          "texshot diff before.json after.json || echo different"}},
        {"scene",
         {"texshot scene --example fog --short", "texshot scene --set view.distance=9 -o far.json",
          "texshot scene far.json | texshot shot - -o far.png"}},
        {"check", {"texshot check", "texshot check --example teapot --json"}},
        {"params", {"texshot params wrap", "texshot params 'textures[].minFilter'", "texshot params --json"}},
        {"presets", {"texshot presets", "texshot shot --preset shimmer -o shimmer.png"}},
        {"lessons",
         {"texshot lessons", "texshot shot --lesson wrap --step 5 --answer 2 -o answer.png",
          "texshot lessons --page handout --lesson wrap"}},
        {"schema",
         {"texshot schema -o scene.schema.json", "texshot schema --suites -o suite.schema.json",
          "texshot schema --outputs"}},
        {"info", {"texshot shot -o cube.png", "texshot info cube.png", "texshot info cube.png --json"}},
        {"validate",
         {"texshot shot -o cube.png; texshot scene -o scene.json", "texshot validate cube.png scene.json"}},
        {"decode",
         {"texshot texture -o in.png", "texshot compress in.png in.dds --format dxt1",
          "texshot decode in.dds level-2.png --level 2"}},
        {"convert",
         {"texshot texture --example cube -o brick.png", "texshot texture --example earth -o earth.png",
          "texshot convert brick.png brick.tga --rle", "texshot convert *.png --to bmp -o pictures"}},
        {"flip",
         {"texshot texture -o in.png; texshot compress in.png in.dds --format dxt5",
          "texshot flip in.dds flipped.dds", "texshot flip in.png mirrored.png --horizontal"}},
        {"compress",
         {"texshot texture -o in.png", "texshot compress in.png out.dds --format dxt1 --report",
          "texshot compress in.png best.dds --format dxt5 --quality best --mips mitchell"}},
        {"drivers", {"texshot drivers", "texshot drivers --json --extensions"}},
        {"cost", {"texshot cost", "texshot cost --example earth --pairs 40 --json"}},
        {"help", {"texshot help shot"}},
    };
    return rows;
}

struct CommandTable {
    std::string_view command;
    HelpTable table;
};

const std::vector<CommandTable>& commandTables() {
    const std::pair<std::string, std::string> score{
        "score",
        "The metric of both pictures: absolute is the mean over all components in 255ths, 0 if equal; ssim "
        "is 1 if equal; flip is 0 if equal and at most 1."};
    const std::pair<std::string, std::string> measured{"metric, tolerance, share",
                                                       "The metric and its tolerance."};
    const std::pair<std::string, std::string> over{"shareOver",
                                                   "The share of pixels above the tolerance, 0 to 1."};
    static const std::vector<CommandTable> rows{
        {"compare",
         {"What --json prints",
          {},
          {{"alike, sentence", "Whether they are alike, and a sentence about it."},
           {"expected, actual, expectedSize, actualSize", "The files and their size in pixels."},
           measured,
           {"components, pixelsPerDegree", "rgba or rgb; for flip, the size of pixels."},
           {"pixels, over", "The number of compared pixels, and of those above the tolerance."},
           over,
           score,
           {"worst", "The worst pixel: x, y, value, expected, actual."},
           {"bounds, regions, largestRegions",
            "Regions of pixels above the tolerance: x, y, width, height, pixels."},
           {"difference", "The max and mean of each component, in 255ths."}}}},
        {"test",
         {"What --json writes",
          {},
          {{"program, command, started, seconds", "The program, start and duration."},
           {"suites, planned, shard, plan", "The suites, the cases of the whole run and the part."},
           {"driver, version", "The driver."},
           {"counts, status", "The number of cases in each state, and the exit status."},
           {"names", "The cases of this part, run or not."},
           {"cases",
            "For each: name, state, sentence, code (the kind of an error), explanation, seconds, attempt, signal, "
            "renderer, driver, width, height, time and golden; settings, the variables for the driver's precision; expectedPicture, "
            "actualPicture and differencePicture in the report's folder; worst, the pixel; fingerprint; "
            "and the following."},
           measured,
           {"pixels, over, unexplained",
            "The number of compared pixels, of those above the tolerance, and of those that the rule, if "
            "any, doesn't explain."},
           over,
           score}}},
        {"test",
         {"Suites",
          "A suite is a JSON file, NAME.suite.json: {\"suite\": 1, \"defaults\": {...}, \"cases\": "
          "[{...}]}. The keys of an entry of cases, or of defaults for all, are below. Lists of one "
          "element may be written without brackets. \"texshot schema --suites\" writes the schema.",
          {{"name", "The beginning of its cases' names. Default: the scene's name."},
           {"scene",
            "A file within the suite's folder, {\"example\": NAME}, {\"lesson\": NAME, \"step\": N} with "
            "\"answer\" or \"reached\", or {\"inline\": {...}}, a complete scene. Default: the start scene."},
           {"set", "Edits, PATH=VALUE or preset:NAME, in this order."},
           {"axis", "PATH=VALUES: a case for each value, or for each combination of several axes."},
           {"size, time, renderer",
            "\"512x512\" pixels, 0 seconds, \"fixed\", \"shader\" or \"reference\": a case for each. "
            "Defaults: 512x512, 0 and fixed."},
           {"golden",
            "Pictures, any of which may match; the same by driver, {\"llvmpipe*\": [...], \"*\": ...}, "
            "where the longest matching name counts; or \"reference\". {case} in a name is the case, "
            "{picture} the case without its renderer, {driver} the driver. Default: golden/{case}.png."},
           {"rule",
            "With \"reference\": auto, none (tolerance and share count), or a name of \"texshot conform "
            "--list\". Default: auto."},
           {"metric, tolerance, share",
            "The metric, the maximum value of a pixel, and the share of pixels that may exceed it, 0.001 "
            "or \"0.1%\". Defaults: absolute, the metric's own, and 0."},
           {"rgb, pixelsPerDegree",
            "true ignores alpha; for flip, the pixels per degree of the field of view. Defaults: false, 67."},
           {"mask", "A picture whose black pixels are ignored."},
           {"seconds", "The time limit of a case. Default: 60."}}}},
        {"sweep",
         {"What --json prints",
          {},
          {{"file, width, height",
            "The file of a sheet and its size in pixels; of single pictures as \"texshot shot\"."},
           {"axes, time", "The axes, as --axis takes them, and the scene's time."},
           {"renderer, driver, version, context", "The renderer and driver, as in \"texshot shot\"."},
           {"cells",
            "For each picture: its place from the upper left (x, y, width, height), values, and warnings "
            "or an error; with --difference, differing, the number of different pixels."}}}},
        {"drivers",
         {"What --json prints",
          {},
          {{"context", "Its name, usable and, if it can't draw, error; driver, vendor, version, "
                       "shadingLanguage, profile, maxTextureSize, maxAnisotropy, s3tc, textureBorders, "
                       "extensionCount; with --extensions, extensions."}}}},
        {"cost",
         {"What --json prints",
          {},
          {{"driver, version, context", "The driver."},
           {"rows",
            "For each: row, label, claim; a and b, with label, seconds (low, median, high) and samples; ratio, "
            "differs and verdict; or lack, why it can't be measured."},
           {"limits", "What the numbers can't tell."}}}},
        {"conform",
         {"What --json prints",
          {},
          {{"program, command, driver, version, settings, seed, scenes, width, height",
            "The driver and the scenes."},
           {"compared, agrees", "Whether anything was compared, and whether all of it agrees."},
           {"pairs",
            "For two renderers, renderer and against: agrees, and features (feature, sweeps, section, "
            "agrees, verdict, rule, all, worstShareOfAScene, shapes, skipped, rho, limits, worst)."},
           {"features, rules, notCompared",
            "With --list instead: the features, the rules, and what isn't compared."}}}},
        {"probe",
         {"What --json prints",
          {},
          {{"at, window, width, height, time",
            "The pixel, from the upper left and as OpenGL counts, and the picture."},
           {"reference, fixed, shader", "Its colour by the specification and by each renderer."},
           {"asRight", "Other correct colours, if a coordinate or the level of detail is on a tie."},
           {"color, background", "The same before it is stored, and the initial colour."},
           {"fragmentCount, firstFragment",
            "The number of fragments that cover it. At most 32 are explained, up to the visible one; the "
            "rest before are skipped."},
           {"fragments",
            "For each fragment: pass, model, shape, face, part, vertices, lighting, units (texture, "
            "coords, sample with lod, levels, probes, wrapped and taps, ties, environment), fog, outcome "
            "and color."},
           {"pass, unit, level, texel, pixels",
            "With --texel instead: the pixels that it contributes to."}}}},
    };
    return rows;
}

} // namespace

void addHelpSections(CommandLine& line) {
    for (const auto& command : line.commands()) {
        const auto found = std::ranges::find(commandExamples(), command->name(), &CommandExamples::command);
        if (found != commandExamples().end())
            command->examples(found->lines);
        for (const auto& [name, table] : commandTables())
            if (name == command->name())
                command->table(table);
    }
}

} // namespace texplorer::screenshot
