#include "app/screenshot/output/columns.h"
#include "app/screenshot/reports/probe_report.h"
#include "texplorer/reference/explain/explanation_steps.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::screenshot {
namespace {

using reference::bytesText;
using reference::PixelBytes;
using reference::Step;
using reference::StepRow;

/// What two renderers may round differently in a byte.
constexpr int sameTie = 1;

/// Numbers stand to the right, so that their signs and points are below each other.
bool isNumber(std::string_view text) {
    return !text.empty() && text.find_first_not_of("-0123456789.") == std::string_view::npos;
}

std::string aligned(const std::string& text, std::size_t width) {
    const std::size_t columns = columnsOf(text);
    const std::string space(width - std::min(width, columns), ' ');
    return isNumber(text) ? space + text : text + space;
}

/// Rows with the same number of cells that follow each other share their columns.
std::string tableOf(const std::vector<StepRow>& rows) {
    constexpr std::size_t maxLabelWidth = 28;
    std::string text;
    for (std::size_t first = 0; first < rows.size();) {
        std::size_t last = first;
        while (last < rows.size() && rows[last].cells.size() == rows[first].cells.size())
            ++last;
        std::size_t label = 0;
        std::vector<std::size_t> widths(rows[first].cells.size());
        for (std::size_t i = first; i < last; ++i) {
            label = std::max(label, columnsOf(rows[i].label));
            for (std::size_t c = 0; c < widths.size(); ++c)
                widths[c] = std::max(widths[c], columnsOf(rows[i].cells[c].text));
        }
        label = std::clamp(label, std::size_t{16}, std::max(maxLabelWidth, label));
        for (std::size_t i = first; i < last; ++i) {
            std::string line =
                "      " + (widths.empty() ? rows[i].label.english() : aligned(rows[i].label, label));
            for (std::size_t c = 0; c < widths.size(); ++c)
                line += "  " + aligned(rows[i].cells[c].text, widths[c]);
            text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
        }
        first = last;
    }
    return text;
}

/// `whole`: with all its numbers, not just with what came of it.
std::string textOf(const Step& step, bool whole) {
    const std::string title =
        (step.unit < 0 ? "" : fmt::format("unit {}, ", step.unit)) + step.title.english();
    return fmt::format("  {}{}\n{}", title, step.summary.empty() ? "" : ": " + step.summary.english(),
                       whole ? tableOf(step.rows) : "");
}

std::string differenceText(const reference::Explanation& explanation, const PixelBytes& theirs) {
    constexpr std::array names{"red", "green", "blue", "alpha"};
    const PixelBytes& ours = explanation.bytes;
    std::string text;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const int by = int{theirs[i]} - int{ours[i]};
        if (by != 0)
            text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", names.at(i), by > 0 ? " +" : " ", by);
    }
    return text.empty()                              ? "the same"
           : isAsRight(explanation, theirs, sameTie) ? fmt::format("{}: also correct, on a tie", text)
                                                     : text;
}

std::string placeText(const reference::TexelQuestion& question) {
    const auto& [level, index] = question.texel;
    return fmt::format("passes[{}].units[{}], level {}, texel {}, {}{}", question.pass, question.unit, level,
                       index.x, index.y, index.z != 0 ? fmt::format(", {}", index.z) : "");
}

} // namespace

std::string asText(const reference::Explanation& explanation, const std::vector<ReadBack>& readBacks) {
    const auto& [x, y] = explanation.pixel;
    std::string text =
        fmt::format("pixel {}, {} of {} × {}, from the top left (in OpenGL's window {}, {})\n", x,
                    explanation.height - 1 - y, explanation.width, explanation.height, x, y);
    text += fmt::format("  reference  {}\n", bytesText(explanation.bytes));
    for (const PixelBytes& each : explanation.asRight)
        text += fmt::format("  or         {}  also correct, on a tie\n", aligned(bytesText(each), 15));
    for (const ReadBack& each : readBacks) {
        text += fmt::format("  {}  ", aligned(std::string(rowOf(each.renderer).name), 9));
        text += each.bytes ? fmt::format("{}  {}", aligned(bytesText(*each.bytes), 15),
                                         differenceText(explanation, *each.bytes))
                           : describe(each.bytes.error()).english();
        text += "\n";
    }
    const auto fragments = stepsOf(explanation);
    if (fragments.empty())
        text += "\n"
                "No model covers it, so it shows the background.\n";
    const std::string cut = cutSentence(explanation);
    text += cut.empty() ? "" : fmt::format("\n{}\n", cut);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        text += fmt::format("\nfragment {} of {}: {}: {}\n", explanation.firstFragment + i + 1,
                            explanation.fragmentCount, fragments[i].title.english(),
                            fragments[i].outcome.english());
        for (const Step& step : fragments[i].steps)
            text += textOf(step, fragments[i].drawn);
    }
    return text;
}

std::string asText(const reference::Contributions& found, const reference::TexelQuestion& question) {
    constexpr std::size_t maxListed = 20;
    struct Pixel {
        int x;
        int y;
        float weight;
    };
    std::vector<Pixel> heaviest; // of equal ones, the lowest and leftmost first
    std::size_t count = 0;
    double sum = 0;
    Pixel least{found.width, found.height, 0};
    Pixel most{-1, -1, 0};
    for (std::size_t i = 0; i < found.weights.size(); ++i) {
        if (!(found.weights[i] > 0))
            continue;
        const auto width = static_cast<std::size_t>(found.width);
        const Pixel pixel{static_cast<int>(i % width), found.height - 1 - static_cast<int>(i / width),
                          found.weights[i]};
        ++count;
        sum += static_cast<double>(pixel.weight);
        least = {std::min(least.x, pixel.x), std::min(least.y, pixel.y), 0};
        most = {std::max(most.x, pixel.x), std::max(most.y, pixel.y), 0};
        if (heaviest.size() == maxListed && !(pixel.weight > heaviest.back().weight))
            continue;
        if (heaviest.size() == maxListed)
            heaviest.pop_back();
        heaviest.insert(
            std::ranges::upper_bound(heaviest, pixel.weight, std::ranges::greater(), &Pixel::weight), pixel);
    }
    std::string text = placeText(question) + "\n";
    if (count == 0)
        return text + "No visible pixel reads it.\n";
    text += fmt::format(
        "{}{} it, x from {} to {}, y from {} to {} (from the top left), {} pixels' worth of colour in all\n",
        count, count == 1 ? " pixel reads" : " pixels read", least.x, most.x, least.y, most.y,
        reference::numberText(static_cast<float>(sum)));
    for (const Pixel& pixel : heaviest)
        text += fmt::format("  {}{}\n", aligned(fmt::format("{}, {}", pixel.x, pixel.y), 12),
                            reference::amountText(pixel.weight));
    if (count > maxListed)
        text += fmt::format("  and {} with less weight; --json lists all\n", count - maxListed);
    return text;
}

} // namespace texplorer::screenshot
