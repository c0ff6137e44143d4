#pragma once

// What `texshot test` tells its worker processes, and what they answer. Bytes pass as they are: a file's name
// may be no UTF-8.

#include "texplorer/compare/criterion.h"
#include "texplorer/scene/renderer.h"
#include "texplorer/suite/record.h"

#include <optional>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// What all orders of a run have in common.
struct RunSetup {
    std::vector<std::string> suites{}; ///< files or folders, as the command line has them
    std::vector<RendererKind> renderers{};
    std::vector<std::string> only{};
    std::string plan{};    ///< the fingerprint of what is planned: a worker reads the suites again
    std::string drawing{}; ///< a hash of what else decides how it is drawn: what a driver is treated as
                           ///< lacking, the files of the shaders
    std::string report{};  ///< the folder for pictures; empty: none
    std::string shaders{};
    std::vector<std::string> pretended{};
    std::string context = "auto"; ///< as view::ContextChoice has it
    unsigned threads = 1;         ///< for the reference and for comparisons

    std::string actual{}; ///< of --pictures: the folders, the mask's file, and what is alike
    std::string golden{};
    std::string mask{};
    Criterion criterion{};

    bool operator==(const RunSetup&) const = default;
};

/// One thing to do.
struct WorkOrder {
    enum class What : std::uint8_t {
        Driver,   ///< open OpenGL and say what it is
        Case,     ///< draw a case of the plan and judge it
        Pictures, ///< judge two files of the same name
    };
    RunSetup setup{};
    What what = What::Driver;
    std::size_t number = 0; ///< of the case
    std::string name{};     ///< of the pictures, below each folder
    bool hasActual = true;
    bool hasGolden = true;
    bool update = false; ///< a golden that is missing or different is written

    bool operator==(const WorkOrder&) const = default;
};

[[nodiscard]] std::string bytesOf(const WorkOrder& order);
[[nodiscard]] Result<WorkOrder> parseOrder(std::string_view bytes);

struct WorkAnswer {
    std::optional<suite::CaseRecord> record{}; ///< of a case or of pictures; its name passes byte by byte
    std::string wrote{};                       ///< the golden that was written, as its suite names it
    std::optional<Error> problem{};            ///< why there is no record, or no driver
    std::string driver{};                      ///< GL_RENDERER
    std::string version{};

    bool operator==(const WorkAnswer&) const = default;
};

[[nodiscard]] std::string bytesOf(const WorkAnswer& answer);
[[nodiscard]] Result<WorkAnswer> parseAnswer(std::string_view bytes);

} // namespace texplorer::screenshot
