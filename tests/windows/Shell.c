/* A shell for one command: runs the program that its arguments name and returns the exit code. Ctrl-C does not end it. */
#include <windows.h>

static BOOL WINAPI stay(DWORD event) {
    return event == CTRL_C_EVENT;
}

int wmain(int count, wchar_t** arguments) {
    wchar_t* line = GetCommandLineW();
    STARTUPINFOW startup = {.cb = sizeof startup};
    PROCESS_INFORMATION process;
    DWORD code = 1;
    if (count < 2 || !SetConsoleCtrlHandler(stay, TRUE))
        return 1;
    line += wcslen(arguments[0]); /* perhaps in quotation marks */
    line = wcschr(line, L' ');
    if (line == NULL || !CreateProcessW(NULL, line + 1, NULL, NULL, TRUE, 0, NULL, NULL, &startup, &process))
        return 1;
    WaitForSingleObject(process.hProcess, INFINITE);
    GetExitCodeProcess(process.hProcess, &code);
    return (int)code;
}
