/* Runs a command in which each `?` of the last argument becomes half of a surrogate pair. Returns the exit code. */
#include <windows.h>

int wmain(int count, wchar_t** arguments) {
    wchar_t* line = GetCommandLineW() + wcslen(arguments[0]);
    wchar_t* last;
    STARTUPINFOW startup = {.cb = sizeof startup};
    PROCESS_INFORMATION process;
    DWORD code = 99;
    line = wcschr(line, L' ');
    if (count < 2 || line == NULL)
        return 98;
    last = wcsrchr(line, L' ');
    for (; last != NULL && *last != 0; ++last)
        if (*last == L'?')
            *last = 0xD83D;
    if (!CreateProcessW(NULL, line + 1, NULL, NULL, TRUE, 0, NULL, NULL, &startup, &process))
        return 97;
    WaitForSingleObject(process.hProcess, INFINITE);
    GetExitCodeProcess(process.hProcess, &code);
    return (int)code;
}
