#include "texplorer/sheet/layout.h"

#include "texplorer/sheet/label_text.h"

#include <algorithm>
#include <cstdint>

namespace texplorer::sheet {
namespace {

constexpr int margin = 24;
constexpr int gap = 12;          // between pictures
constexpr int labelGap = 6;      // between a picture and its words
constexpr int titleGap = 4;      // below the title, before what says more
constexpr int headGap = 16;      // below what stands above the pictures
constexpr int minPitch = 128;    // that a small picture's label may take
constexpr int maxRowLabel = 220; // that the labels of rows may take
constexpr int maxHeader = 420;   // that title and caption may take beyond the pictures
constexpr std::size_t labelLineCount = 2;
constexpr std::size_t rowLabelLineCount = 3;
constexpr std::size_t captionLineCount = 3;

using Lines = std::vector<std::string>;

/// Puts down what is there, and asks how large words are.
class Pen {
public:
    explicit Pen(const Lettering& lettering)
        : lettering_(lettering) {}

    [[nodiscard]] int width(TextRole role, std::string_view text) const {
        return lettering_.width(role, text);
    }
    [[nodiscard]] int height(TextRole role, std::size_t lines = 1) const {
        return lettering_.lineHeight(role) * static_cast<int>(lines);
    }
    [[nodiscard]] Lines broken(TextRole role, std::string_view text, int room, std::size_t most) const {
        return labelLines(text, room, most,
                          [&](std::string_view words) { return lettering_.width(role, words); });
    }
    [[nodiscard]] int widest(TextRole role, const Lines& texts) const {
        int most = 0;
        for (const std::string& each : texts)
            most = std::max(most, width(role, each));
        return most;
    }

    enum class Side { Left, Center, Right };
    /// Lines in a room from `left` on.
    void put(Layout& layout, TextRole role, const Lines& lines, int left, int top, int room,
             Side side) const {
        for (const std::string& each : lines) {
            const int free = std::max(0, room - width(role, each));
            const int indent = side == Side::Left ? 0 : side == Side::Right ? free : free / 2;
            layout.lines.push_back({left + indent, top, role, each});
            top += height(role);
        }
    }

private:
    const Lettering& lettering_;
};

/// The grid of pictures, with the texts next to them.
struct Grid {
    std::size_t columns = 1;
    std::size_t rows = 1;
    std::size_t count = 1;
    int pitch = 1;                  ///< the room of a picture and of its label
    int corner = 0;                 ///< the room of the rows' labels, with the gap behind it
    int headHeight = 0;             ///< what stands above the pictures, with the gap below it
    int rowHeight = 1;              ///< of a picture with what is below it
    Lines downTitle{};              ///< of a table
    std::vector<Lines> rowLabels{}; ///< of a table
    std::vector<Lines> labels{};    ///< of pictures, or of columns

    [[nodiscard]] std::int64_t width() const { return corner + spread(columns, pitch); }
    [[nodiscard]] std::int64_t height() const { return headHeight + spread(rows, rowHeight); }

private:
    static std::int64_t spread(std::size_t number, int each) {
        const auto many = static_cast<std::int64_t>(number);
        return many * (each + gap) - gap;
    }
};

std::size_t maxLines(const std::vector<Lines>& labels) {
    std::size_t most = 0;
    for (const Lines& each : labels)
        most = std::max(most, each.size());
    return most;
}

std::vector<Lines> brokenLabels(const Pen& pen, const Lines& texts, int room, std::size_t most) {
    std::vector<Lines> labels;
    labels.reserve(texts.size());
    for (const std::string& each : texts)
        labels.push_back(pen.broken(TextRole::Label, each, room, most));
    return labels;
}

int noteHeight(const Content& content, const Pen& pen) {
    return !content.widestNote.empty() ? pen.height(TextRole::Note) : 0;
}

int pitchFor(const Content& content, const Pen& pen, const Lines& texts) {
    const int words =
        std::max(pen.widest(TextRole::Label, texts), pen.width(TextRole::Note, content.widestNote));
    return std::max(content.cell.x, std::min(words, minPitch));
}

Grid wrappedGrid(const Content& content, const Pen& pen) {
    const Lines& texts = content.down.values;
    Grid grid;
    grid.count = texts.size();
    grid.columns = columnsFor(grid.count);
    grid.rows = (grid.count + grid.columns - 1) / grid.columns;
    grid.pitch = pitchFor(content, pen, texts);
    grid.labels = brokenLabels(pen, texts, grid.pitch, labelLineCount);
    grid.rowHeight = content.cell.y + labelGap + pen.height(TextRole::Label, maxLines(grid.labels)) +
                     noteHeight(content, pen);
    return grid;
}

Grid tableGrid(const Content& content, const Pen& pen) {
    Grid grid;
    grid.rows = content.down.values.size();
    grid.columns = content.across->values.size();
    grid.count = grid.rows * grid.columns;
    grid.pitch = pitchFor(content, pen, content.across->values);
    grid.labels = brokenLabels(pen, content.across->values, grid.pitch, labelLineCount);
    const int room = std::min(maxRowLabel, std::max(pen.widest(TextRole::Label, content.down.values),
                                                    pen.width(TextRole::Heading, content.down.title)));
    grid.rowLabels = brokenLabels(pen, content.down.values, room, rowLabelLineCount);
    grid.downTitle = pen.broken(TextRole::Heading, content.down.title, room, labelLineCount);
    int widest = pen.widest(TextRole::Heading, grid.downTitle);
    for (const Lines& each : grid.rowLabels)
        widest = std::max(widest, pen.widest(TextRole::Label, each));
    grid.corner = widest + gap;
    const int columnHead =
        pen.height(TextRole::Heading) + labelGap + pen.height(TextRole::Label, maxLines(grid.labels));
    grid.headHeight = std::max(columnHead, pen.height(TextRole::Heading, grid.downTitle.size())) + labelGap;
    const int picture =
        content.cell.y + (!content.widestNote.empty() ? labelGap / 2 + noteHeight(content, pen) : 0);
    grid.rowHeight = std::max(picture, pen.height(TextRole::Label, maxLines(grid.rowLabels)));
    return grid;
}

void putTableHeads(Layout& layout, const Content& content, const Pen& pen, const Grid& grid, int left,
                   int top) {
    const int bottom = top + grid.headHeight - labelGap;
    const int across = static_cast<int>(grid.width()) - grid.corner;
    pen.put(layout, TextRole::Heading, pen.broken(TextRole::Heading, content.across->title, across, 1),
            left + grid.corner, top, across, Pen::Side::Center);
    pen.put(layout, TextRole::Heading, grid.downTitle, left,
            bottom - pen.height(TextRole::Heading, grid.downTitle.size()), grid.corner - gap,
            Pen::Side::Right);
    for (std::size_t i = 0; i < grid.columns; ++i)
        pen.put(layout, TextRole::Label, grid.labels[i],
                left + grid.corner + static_cast<int>(i) * (grid.pitch + gap),
                bottom - pen.height(TextRole::Label, grid.labels[i].size()), grid.pitch, Pen::Side::Center);
    for (std::size_t i = 0; i < grid.rows; ++i) {
        const int cellTop = top + grid.headHeight + static_cast<int>(i) * (grid.rowHeight + gap);
        const int height = pen.height(TextRole::Label, grid.rowLabels[i].size());
        pen.put(layout, TextRole::Label, grid.rowLabels[i], left,
                cellTop + std::max(0, (content.cell.y - height) / 2), grid.corner - gap, Pen::Side::Right);
    }
}

/// One picture, what is written below it, and where its note will be.
void putCell(Layout& layout, const Content& content, const Pen& pen, const Grid& grid, std::size_t cell,
             int left, int top) {
    layout.cells.push_back({left + (grid.pitch - content.cell.x) / 2, top, content.cell.x, content.cell.y});
    int below = top + content.cell.y + (content.across ? labelGap / 2 : labelGap);
    if (!content.across) {
        pen.put(layout, TextRole::Label, grid.labels[cell], left, below, grid.pitch, Pen::Side::Center);
        below += pen.height(TextRole::Label, grid.labels[cell].size());
    }
    if (!content.widestNote.empty())
        layout.notes.push_back({left, below, grid.pitch, noteHeight(content, pen)});
}

} // namespace

std::size_t columnsFor(std::size_t count) {
    std::size_t square = 1;
    while (square * square < count)
        ++square;
    const auto gaps = [count](std::size_t columns) { return (columns - count % columns) % columns; };
    return count > 2 && gaps(square + 1) < gaps(square) ? square + 1 : square;
}

Result<Layout> layoutOf(const Content& content, const Lettering& lettering) {
    const Pen pen(lettering);
    const Grid grid = content.across ? tableGrid(content, pen) : wrappedGrid(content, pen);
    const std::string& second = content.across ? content.subtitle : content.down.title;
    const std::string& third = content.across ? std::string() : content.subtitle;
    const auto wide = grid.width();
    const int header =
        std::min(maxHeader,
                 std::max({pen.width(TextRole::Title, content.title), pen.width(TextRole::Heading, second),
                           pen.width(TextRole::Heading, third), pen.width(TextRole::Note, content.caption)}));
    const std::int64_t room = std::max<std::int64_t>(wide, header);
    const auto tooLarge = [](std::int64_t width, std::int64_t height) {
        return fail(ErrorCode::TooLarge,
                    Sentence("expected a sheet of at most {0} × {0} pixels, this one would have {1} × "
                             "{2}: use smaller pictures or fewer values",
                             maxSheetExtent, width, height));
    };
    Layout layout;
    int top = margin;
    const auto put = [&](TextRole role, const std::string& text, std::size_t most) {
        const Lines lines =
            pen.broken(role, text, static_cast<int>(std::min<std::int64_t>(room, maxSheetExtent)), most);
        pen.put(layout, role, lines, margin, top, 0, Pen::Side::Left);
        top += pen.height(role, lines.size());
    };
    put(TextRole::Title, content.title, 1);
    if (!second.empty() || !third.empty())
        top += titleGap;
    put(TextRole::Heading, second, labelLineCount);
    put(TextRole::Heading, third, labelLineCount);
    top += headGap;
    const std::int64_t bottom = top + grid.height();
    if (room + 2 * margin > maxSheetExtent || bottom + margin > maxSheetExtent)
        return tooLarge(room + 2 * margin, bottom + margin);
    const int left = margin + static_cast<int>((room - wide) / 2);
    if (content.across)
        putTableHeads(layout, content, pen, grid, left, top);
    for (std::size_t i = 0; i < grid.count; ++i)
        putCell(layout, content, pen, grid, i,
                left + grid.corner + static_cast<int>(i % grid.columns) * (grid.pitch + gap),
                top + grid.headHeight + static_cast<int>(i / grid.columns) * (grid.rowHeight + gap));
    top = static_cast<int>(bottom);
    if (!content.caption.empty()) {
        top += gap;
        put(TextRole::Note, content.caption, captionLineCount);
    }
    layout.size = {static_cast<int>(room) + 2 * margin, top + margin};
    if (layout.size.y > maxSheetExtent)
        return tooLarge(layout.size.x, layout.size.y);
    return layout;
}

} // namespace texplorer::sheet
