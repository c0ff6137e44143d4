#pragma once

// A driver that is treated as if it lacked something: what --pretend takes. What old hardware could not do is
// then drawn, said and mended on new hardware as on the old. The reference, which draws as the specification
// says, asks no driver and pretends nothing.

#include "app/view/capabilities.h"
#include "core/base/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::view {

/// Something that a driver can lack.
struct PretenceRow {
    std::string_view word; ///< "no-s3tc"; "units=" is followed by a number
    std::string_view help;
    int low;  ///< of the number
    int high; ///< 0: there is no number
    /// Takes it away; never gives what the driver lacks itself.
    void (*limit)(Capabilities& capabilities, int number);
};

[[nodiscard]] std::span<const PretenceRow> pretenceRows();

/// What is pretended, all of it together.
class Pretence {
public:
    /// Of words with commas between them. The error is about "--pretend": an unknown word, or a number that
    /// is missing, superfluous or out of range.
    [[nodiscard]] static Result<Pretence> parse(const std::vector<std::string>& texts);

    /// The driver as it is treated.
    [[nodiscard]] Capabilities of(Capabilities driver) const;

    /// As parse() takes it: "no-s3tc,units=2". Empty: nothing is pretended.
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

/// The words that parse() takes; what a number follows ends in =.
[[nodiscard]] std::vector<std::string> pretenceWords();

/// For --help: what the option does, and its words.
[[nodiscard]] std::string pretenceHelp();

} // namespace texplorer::view
