/* A substitute for ffmpeg.exe: copies its standard input to the file that its last argument names. */
#include <fcntl.h>
#include <io.h>
#include <stdio.h>
#include <windows.h>

int wmain(int count, wchar_t** arguments) {
    char bytes[65536];
    size_t got;
    FILE* film = _wfopen(arguments[count - 1], L"wb");
    _setmode(_fileno(stdin), _O_BINARY);
    if (film == NULL)
        return 1;
    while ((got = fread(bytes, 1, sizeof bytes, stdin)) > 0)
        fwrite(bytes, 1, got, film);
    return fclose(film) == 0 ? 0 : 1;
}
