#pragma once

#include <CLI/CLI.hpp>

#include <charconv>
#include <string>

namespace texplorer::screenshot {

/// An option that takes a whole number from `low` to `high`; `value` must live as long as the command.
template<class T>
CLI::Option* addNumber(CLI::App& command, const std::string& option, T& value, long long low, long long high,
                       const std::string& help) {
    const auto parse = [&value, option, low, high](const std::string& text) {
        long long number = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || stop != text.data() + text.size() || number < low || number > high)
            throw CLI::ValidationError(option, "expected a whole number from " + std::to_string(low) +
                                                   " to " + std::to_string(high) + ", found \"" + text +
                                                   "\"");
        value = static_cast<T>(number);
    };
    const std::string range = " From " + std::to_string(low) + " to " + std::to_string(high) + ".";
    return command.add_option_function<std::string>(option, parse, help + range)->type_name("NUMBER");
}

} // namespace texplorer::screenshot
