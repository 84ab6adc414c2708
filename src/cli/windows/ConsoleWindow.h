#pragma once

#include <filesystem>
#include <string>

namespace limen::cli {

/// The console of a program that writes UTF-8 and VT sequences. The destructor restores its settings.
class ConsoleWindow {
public:
    ConsoleWindow();
    ~ConsoleWindow();
    ConsoleWindow(const ConsoleWindow&) = delete;
    ConsoleWindow& operator=(const ConsoleWindow&) = delete;

private:
    unsigned codePage_ = 0;
    unsigned long outMode_ = 0, errorMode_ = 0;
};

/// True if no one reads standard error: the program was started by a double click, and its console, if it has one, is
/// its own.
[[nodiscard]] bool isWithoutReader();

/// Lets the own console go, and writes messages to `file` instead. For windows: the desktop shows no empty console.
void leaveConsole(const std::filesystem::path& file);

/// Shows the text of `file` in a box.
void showMessages(const std::filesystem::path& file);

} // namespace limen::cli
