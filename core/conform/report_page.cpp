#include "core/codec/png.h"
#include "core/conform/report.h"
#include "core/image/convert.h"
#include "core/scene/json.h"

#include <array>
#include <cstdio>

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
th:first-child, td:first-child, th:last-child, td:last-child { text-align: left; }
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
    std::string result;
    for (const char each : text) {
        if (each == '<')
            result += "&lt;";
        else if (each == '&')
            result += "&amp;";
        else if (each == '"')
            result += "&quot;";
        else
            result += each;
    }
    return result;
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

std::string percent(double share) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3f %%", share * 100);
    return text.data();
}

std::string figure(ByteView png, std::string_view caption) {
    return "<figure><img alt=\"\" src=\"data:image/png;base64," + base64(png) + "\"><figcaption>" +
           escaped(caption) + "</figcaption></figure>\n";
}

std::string legend(const HeatScale& scale) {
    std::string text = "<div class=\"legend\">";
    for (const int value : {0, 1, 2, 4, 8, 16, 32, 64, 128, 255}) {
        const auto color = heatColor(static_cast<float>(value), scale);
        const bool dark = color[0] + color[1] < 260;
        text += "<span style=\"background:rgb(" + std::to_string(color[0]) + "," + std::to_string(color[1]) +
                "," + std::to_string(color[2]) + ");color:" + (dark ? "#fff" : "#000") + "\">" +
                std::to_string(value) + "</span>";
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
    std::string text = "<article id=\"" + name + "\"><h3>" + std::string(outcome.feature->name) +
                       "</h3>\n<p>" + escaped(outcome.feature->sweeps) + " (OpenGL 2.1, " +
                       escaped(outcome.feature->section) + ")</p>\n<p>Its worst scene, <a href=\"" + name +
                       ".json\">" + name + ".json</a>: " + std::to_string(judgement.difference.over) +
                       " pixels over " + std::to_string(outcome.rule->bound) + ", " +
                       std::to_string(judgement.unexplained) + " of them unexplained; the worst by " +
                       std::to_string(judgement.difference.max) + " at " +
                       std::to_string(judgement.difference.worst.x) + ", " +
                       std::to_string(judgement.difference.worst.y) + " from the lower left.</p>\n";
    text += "<div class=\"pictures\">" + figure(pictures.subject, rowOf(pair.pair.subject).label) +
            figure(pictures.against, rowOf(pair.pair.against).label) +
            figure(pictures.difference, "Difference") + "</div>\n" + legend({outcome.rule->bound, 255});
    return text + "<p>Rule <b>" + std::string(outcome.rule->name) + "</b>: " + escaped(outcome.rule->reason) +
           "</p></article>\n";
}

std::string table(const PairReport& pair) {
    std::string text =
        "<table><tr><th>feature<th>scenes<th>skipped<th>pixels<th>over the bound<th>unexplained"
        "<th>worst<th>mean<th>verdict</tr>\n";
    std::string notes;
    for (const Outcome& outcome : pair.outcomes) {
        int skipped = 0;
        for (const auto& [skip, count] : outcome.skipped)
            skipped += count;
        for (const auto& [skip, count] : outcome.skipped)
            notes += "<p>" + std::string(outcome.feature->name) + ": " + std::to_string(count) +
                     " scenes skipped (" + std::string(skip->name) + "): " + escaped(skip->reason) +
                     ".</p>\n";
        if (!outcome.problem.empty())
            notes += "<p class=\"differ\">" + std::string(outcome.feature->name) + ": " +
                     escaped(outcome.problem) + "</p>\n";
        const Tally& all = outcome.all;
        const std::string name = outcome.worst ? "<a href=\"#" + worstName(pair, outcome) + "\">" +
                                                     std::string(outcome.feature->name) + "</a>"
                                               : std::string(outcome.feature->name);
        std::array<char, 32> mean{};
        std::snprintf(mean.data(), mean.size(), "%.3f", all.mean());
        text += "<tr><td>" + name;
        for (const std::string& cell :
             {std::to_string(all.scenes), std::to_string(skipped), std::to_string(all.pixels),
              percent(all.shareOver()),
              outcome.rule->latitude == Latitude::None ? "–" : percent(all.shareUnexplained()),
              std::to_string(all.max), std::string(mean.data())})
            text += "<td>" + cell;
        text += all.scenes == 0    ? "<td>skipped"
                : outcome.agrees() ? "<td class=\"agree\">agree"
                                   : "<td class=\"differ\">differ";
        text += "</tr>\n";
    }
    return text + "</table>\n" + notes;
}

Bytes bytesOf(std::string_view text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

} // namespace

Result<std::vector<ReportFile>> asFolder(const Report& report) {
    std::vector<ReportFile> files;
    std::string page(head);
    page += "<h1>Do the renderers agree?</h1>\n<p>" + std::to_string(report.scenes) + " scenes of " +
            std::to_string(extent) + " x " + std::to_string(extent) + " pixels, seed " +
            std::to_string(report.selection.seed);
    if (!report.driver.name.empty())
        page += ", on " + escaped(report.driver.name) + ", " + escaped(report.driver.version) +
                (report.driver.settings.empty() ? "" : ", with " + escaped(report.driver.settings));
    page += std::string(": <b class=\"") + (report.agrees() ? "agree" : "differ") + "\">" + summary(report) +
            "</b>";
    page +=
        ".</p>\n<p>A pixel is over the bound when a component differs by more than its rule allows, and "
        "unexplained when what the rule grants a driver's arithmetic does not explain it either. Differences "
        "are in 255ths. Open a scene with <code>texplorer FILE</code>.</p>\n";
    for (const PairReport& pair : report.pairs) {
        page += "<h2>" + std::string(rowOf(pair.pair.subject).label) + " against " +
                std::string(rowOf(pair.pair.against).label) + "</h2>\n" + table(pair);
        for (const Outcome& outcome : pair.outcomes) {
            if (!outcome.worst)
                continue;
            Result<Pictures> pictures = picturesOf(outcome);
            if (!pictures)
                return fail(pictures.error());
            page += article(pair, outcome, *pictures);
            const std::string name = worstName(pair, outcome);
            files.push_back({name + ".json", bytesOf(writeScene(outcome.worst->scene))});
            files.push_back({name + "-" + std::string(rowOf(pair.pair.subject).name) + ".png",
                             std::move(pictures->subject)});
            files.push_back({name + "-" + std::string(rowOf(pair.pair.against).name) + ".png",
                             std::move(pictures->against)});
            files.push_back({name + "-difference.png", std::move(pictures->difference)});
        }
    }
    files.push_back({"report.json", bytesOf(asJson(report))});
    files.push_back({"index.html", bytesOf(page + "</html>\n")});
    return files;
}

} // namespace texplorer::conform
