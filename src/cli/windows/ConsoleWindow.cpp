#include "cli/windows/ConsoleWindow.h"

#include "core/platform/Files.h"
#include "core/platform/windows/Text.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <io.h>
#include <iterator>
#include <windows.h>

namespace limen::cli {
namespace {

void addVtSequences(DWORD handle, unsigned long& before) {
    const HANDLE console = GetStdHandle(handle);
    if (GetConsoleMode(console, &before) != 0)
        SetConsoleMode(console, before | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

void restore(DWORD handle, unsigned long before) {
    if (before != 0)
        SetConsoleMode(GetStdHandle(handle), before);
}

bool isFileOrPipe(DWORD handle) {
    const DWORD type = GetFileType(GetStdHandle(handle));
    return type == FILE_TYPE_DISK || type == FILE_TYPE_PIPE;
}

} // namespace

ConsoleWindow::ConsoleWindow() : codePage_(GetConsoleOutputCP()) {
    SetConsoleOutputCP(CP_UTF8);
    addVtSequences(STD_OUTPUT_HANDLE, outMode_);
    addVtSequences(STD_ERROR_HANDLE, errorMode_);
}

ConsoleWindow::~ConsoleWindow() {
    if (codePage_ != 0)
        SetConsoleOutputCP(codePage_);
    restore(STD_OUTPUT_HANDLE, outMode_);
    restore(STD_ERROR_HANDLE, errorMode_);
}

bool isWithoutReader() {
    if (isFileOrPipe(STD_ERROR_HANDLE))
        return false;
    std::array<DWORD, 2> processes{};
    // The processes of the console: 0 without a console, 1 if it is this program's own.
    return GetConsoleProcessList(processes.data(), static_cast<DWORD>(processes.size())) <= 1;
}

void leaveConsole(const std::filesystem::path& file) {
    FreeConsole();
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    if (_wfreopen(file.c_str(), L"wb", stderr) == nullptr)
        (void)_wfreopen(L"NUL", L"wb", stderr);
    if (!isFileOrPipe(STD_OUTPUT_HANDLE))
        (void)_wfreopen(L"NUL", L"wb", stdout);
}

void showMessages(const std::filesystem::path& file) {
    (void)std::fflush(stderr);
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!text.empty())
        MessageBoxW(nullptr, platform::wideText(text).c_str(), L"Limen", MB_OK | MB_ICONERROR);
}

} // namespace limen::cli
