#include "core/base/count.h"
#include "core/base/html.h"
#include "core/base/printable.h"
#include "core/codec/png/png.h"
#include "core/compare/heat_map.h"
#include "core/conform/made_files.h"
#include "core/conform/report.h"
#include "core/conform/report_words.h"
#include "core/image/convert.h"
#include "core/scene/params/json.h"

#include <fmt/core.h>

#include <array>

namespace texplorer::conform {

namespace {

constexpr std::string_view head = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Do the renderers agree?</title>
<style>
:root { color-scheme: light dark; --line: #8884; --soft: #8882; --bad: #d33; --good: #2a8; }
body { font: 15px/1.45 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin-bottom: .2rem; }
h2 { margin-top: 2.5rem; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .6rem; border-bottom: 1px solid var(--line); text-align: right; }
th:first-child, td:first-child, th:nth-last-child(-n+2), td:nth-last-child(-n+2) { text-align: left; }
.agree { color: var(--good); }
.differ { color: var(--bad); font-weight: 600; }
article { border-top: 1px solid var(--line); padding: 1rem 0; }
article h3 { margin: 0 0 .3rem; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: .5rem 0; }
figcaption { font-size: .85rem; opacity: .8; }
img { width: 256px; height: 256px; image-rendering: pixelated; background: var(--soft); }
.legend { display: flex; flex-wrap: wrap; font-size: .8rem; }
.legend span { padding: .1rem .45rem; min-width: 1.6rem; text-align: center; }
p { margin: .3rem 0; }
</style>
)";

std::string escaped(std::string_view text) {
    return escapedHtml(printable(text));
}

std::string base64(ByteView bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        // Three bytes are four digits of six bits; what is missing at the end is '='.
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8U | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[(bits >> (18 - 6 * k)) & 63U] : '=';
    }
    return text;
}

std::string figure(ByteView png, std::string_view caption) {
    return fmt::format(
        "<figure><img alt=\"\" src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n",
        base64(png), escaped(caption));
}

std::string legend(const HeatScale& scale) {
    std::string text = "<div class=\"legend\">";
    for (const int value : {0, 1, 2, 4, 8, 16, 32, 64, 128, 255}) {
        const auto color = heatColor(static_cast<float>(value), scale);
        const bool dark = color[0] + color[1] < 260;
        text += fmt::format("<span style=\"background:rgb({},{},{});color:{}\">{}</span>", color[0], color[1],
                            color[2], dark ? "#fff" : "#000", value);
    }
    return text + "</div>\n";
}

struct Pictures {
    Bytes subject;
    Bytes against;
    Bytes difference;
};

Result<Pictures> picturesOf(const Outcome& outcome) {
    const Worst& worst = *outcome.worst;
    const Result<Image> heat = heatMap(worst.subject, worst.against, {outcome.rule->bound, 255});
    if (!heat)
        return fail(heat.error());
    Result<Bytes> subject = encodePng(worst.subject);
    Result<Bytes> against = encodePng(worst.against);
    Result<Bytes> difference = encodePng(withoutAlpha(*heat));
    for (const Result<Bytes>* each : {&subject, &against, &difference}) {
        if (!*each)
            return fail(each->error());
    }
    return Pictures{std::move(*subject), std::move(*against), std::move(*difference)};
}

std::string article(const PairReport& pair, const Outcome& outcome, const Pictures& pictures) {
    const std::string name = worstName(pair, outcome);
    const Judgement& judgement = outcome.worst->judgement;
    const auto [x, y] = placeOfWorst(judgement);
    const std::string at = fmt::format("{},{}", x, y);
    std::string text =
        fmt::format("<article id=\"{0}\"><h3>{1}</h3>\n"
                    "<p>{2} (OpenGL 2.1, {3})</p>\n"
                    "<p>Its worst scene, <a href=\"{0}.json\">{0}.json</a>: {4} pixels over {5}",
                    name, outcome.feature->name, escaped(outcome.feature->sweeps),
                    escaped(outcome.feature->section), judgement.difference.over, outcome.rule->bound);
    if (outcome.rule->tolerance != Tolerance::None)
        text += fmt::format(", {} of them unexplained", judgement.unexplained);
    if (judgement.difference.max > 0)
        text += fmt::format("; the worst by {0} at {1}, counted from the upper left: "
                            "<code>texshot probe {2}.json --size {3}x{3} --at {1}</code>",
                            judgement.difference.max, at, name, extent);
    text += fmt::format(".</p>\n<div class=\"pictures\">{}{}{}</div>\n{}",
                        figure(pictures.subject, rowOf(pair.pair.subject).label),
                        figure(pictures.against, rowOf(pair.pair.against).label),
                        figure(pictures.difference, "Difference"), legend({outcome.rule->bound, 255}));
    return fmt::format("{}<p>Rule <b>{}</b>, {}: {}</p></article>\n", text, outcome.rule->name,
                       allowed(*outcome.rule), escaped(outcome.rule->reason));
}

std::string rowOfTable(const PairReport& pair, const Outcome& outcome) {
    const Tally& all = outcome.all;
    const std::string feature(outcome.feature->name);
    const std::string verdict(conform::verdict(outcome));
    std::string text = "<tr><td>";
    text +=
        outcome.worst ? fmt::format("<a href=\"#{}\">{}</a>", worstName(pair, outcome), feature) : feature;
    for (const std::string& cell :
         {std::to_string(all.scenes), std::to_string(skippedOf(outcome)), std::to_string(all.pixels),
          escaped(percent(all.shareOver())),
          outcome.rule->tolerance == Tolerance::None ? "–" : escaped(percent(all.shareUnexplained())),
          std::to_string(all.max), fmt::format("{:.3f}", all.mean())})
        text += "<td>" + cell;
    return fmt::format("{0}<td class=\"{1}\">{1}<td>{2}</tr>\n", text, verdict,
                       escaped(allowed(*outcome.rule)));
}

std::string table(const PairReport& pair) {
    std::string text =
        "<table><tr><th>feature<th>scenes<th>skipped<th>pixels<th>over the bound<th>unexplained"
        "<th>worst<th>mean<th>verdict<th>allowed</tr>\n";
    std::string notes;
    for (const Outcome& outcome : pair.outcomes) {
        text += rowOfTable(pair, outcome);
        const std::string feature(outcome.feature->name);
        for (const auto& [skip, count] : outcome.skipped)
            notes += fmt::format("<p>{}: {} skipped ({}): {}.</p>\n", feature, countOf(count, "scene"),
                                 skip->name, escaped(skip->reason));
        if (!outcome.problem.empty())
            notes += fmt::format("<p class=\"differ\">{}: {}</p>\n", feature, escaped(outcome.problem));
    }
    return fmt::format("{}</table>\n{}", text, notes);
}

std::string introduction(const Report& report) {
    const Origin& origin = report.origin;
    std::string text = fmt::format(
        "<h1>Do the renderers agree?</h1>\n<p>{},{}: <b class=\"{}\">{}</b>.</p>\n<p>", whatWasDrawn(report),
        escaped(onWhat(report.driver)), report.agrees() ? "agree" : "differ", summary(report));
    if (!origin.program.empty())
        text += fmt::format("Made by {}{} in {:.1f} s; again: <code>{}</code>.</p>\n<p>",
                            escaped(origin.program), origin.made.empty() ? "" : " on " + escaped(origin.made),
                            report.seconds, escaped(origin.command));
    return text +
           "A pixel is over the bound when a component differs by more than its rule allows, and unexplained "
           "when what the rule grants a driver's arithmetic does not explain it either. Differences are in "
           "255ths. Open a scene with <code>texplorer FILE</code>.</p>\n";
}

Bytes bytesOf(std::string_view text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

} // namespace

Result<std::vector<ReportFile>> asFolder(const Report& report) {
    std::vector<ReportFile> files;
    std::string page = std::string(head) + introduction(report);
    for (const PairReport& pair : report.pairs) {
        page += fmt::format("<h2>{} against {}</h2>\n{}", rowOf(pair.pair.subject).label,
                            rowOf(pair.pair.against).label, table(pair));
        for (const Outcome& outcome : pair.outcomes) {
            if (!outcome.worst)
                continue;
            Result<Pictures> pictures = picturesOf(outcome);
            if (!pictures)
                return fail(pictures.error());
            page += article(pair, outcome, *pictures);
            const std::string name = worstName(pair, outcome);
            files.push_back({name + ".json", bytesOf(writeScene(outcome.worst->scene))});
            files.push_back({fmt::format("{}-{}.png", name, rowOf(pair.pair.subject).name),
                             std::move(pictures->subject)});
            files.push_back({fmt::format("{}-{}.png", name, rowOf(pair.pair.against).name),
                             std::move(pictures->against)});
            files.push_back({name + "-difference.png", std::move(pictures->difference)});
        }
    }
    for (const MadeFile& file : madeFiles)
        files.push_back({std::string(file.name), bytesOf(file)});
    files.push_back({"report.json", bytesOf(asJson(report))});
    files.push_back({"index.html", bytesOf(page + "</html>\n")});
    return files;
}

} // namespace texplorer::conform
