#pragma once

// A driver that is treated as if it lacked features: the option --pretend. The window then draws, reports and
// fixes on new hardware what old hardware could not do. The reference draws as the specification says, and
// follows only the largest sizes of textures, where the scene asks for smaller levels.

#include "app/view/capabilities.h"
#include "app/view/driver_facts.h"
#include "texplorer/base/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::view {

/// A feature that a driver can lack.
struct PretenceRow {
    std::string_view word; ///< "no-s3tc"; "units=" is followed by a number
    std::string_view help;
    int low;  ///< of the number
    int high; ///< 0: there is no number
    /// Removes the feature; never adds one that the driver lacks.
    void (*limit)(Capabilities& capabilities, int number);
};

[[nodiscard]] std::span<const PretenceRow> pretenceRows();

/// All pretended limits together.
class Pretence {
public:
    /// Parses words separated by commas. The error is about "--pretend": an unknown word, or a number that is
    /// missing, superfluous or out of range.
    [[nodiscard]] static Result<Pretence> parse(const std::vector<std::string>& texts);

    /// The driver's capabilities with the limits applied.
    [[nodiscard]] Capabilities of(Capabilities driver) const;

    /// A driver that lacks nothing else.
    [[nodiscard]] DriverFacts facts() const;
    /// Whether it concerns the reference, too: Oversize::Smaller.
    [[nodiscard]] bool limitsTextures() const { return facts().limits() != TextureLimits{}; }

    /// In the format of parse(): "no-s3tc,units=2". Empty: nothing is pretended.
    [[nodiscard]] std::string text() const;

private:
    struct Lack {
        const PretenceRow* row;
        int number;
    };

    static std::string wordOf(const Lack& lack);
    Result<void> add(std::string_view word);

    std::vector<Lack> lacks_;
};

/// The words that parse() accepts; those with a number end in =.
[[nodiscard]] std::vector<std::string> pretenceWords();

/// For --help: describes the option and its words.
[[nodiscard]] std::string pretenceHelp();

} // namespace texplorer::view
