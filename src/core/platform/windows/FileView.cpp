#include "core/platform/FileView.h"

#include "core/platform/windows/Text.h"

#include <utility>
#include <windows.h>

namespace limen::platform {
namespace {

/// Closes a handle on destruction.
struct MappedHandle {
    HANDLE handle = nullptr;
    ~MappedHandle() {
        if (handle != nullptr && handle != INVALID_HANDLE_VALUE)
            CloseHandle(handle);
    }
};

Failure unreadable(const std::filesystem::path& path) {
    const DWORD error = GetLastError();
    if (error == ERROR_FILE_NOT_FOUND || error == ERROR_PATH_NOT_FOUND || error == ERROR_INVALID_NAME)
        return fail(ErrorCode::NotFound, path.string(), "there is no such file");
    return fail(ErrorCode::Unreadable, path.string(), errorText(error));
}

} // namespace

Result<FileView> mapFile(const std::filesystem::path& path) {
    const DWORD attributes = GetFileAttributesW(path.c_str());
    if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0)
        return fail(ErrorCode::Unreadable, path.string(), "this is not a regular file");
    constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    const MappedHandle file{CreateFileW(path.c_str(), GENERIC_READ, kShared, nullptr, OPEN_EXISTING,
                                        FILE_FLAG_RANDOM_ACCESS, nullptr)};
    if (file.handle == INVALID_HANDLE_VALUE)
        return unreadable(path);
    if (GetFileType(file.handle) != FILE_TYPE_DISK)
        return fail(ErrorCode::Unreadable, path.string(), "this is not a regular file");
    LARGE_INTEGER size{};
    if (GetFileSizeEx(file.handle, &size) == 0)
        return unreadable(path);
    if (size.QuadPart == 0)
        return FileView();
    const MappedHandle mapping{CreateFileMappingW(file.handle, nullptr, PAGE_READONLY, 0, 0, nullptr)};
    const void* address =
        mapping.handle != nullptr ? MapViewOfFile(mapping.handle, FILE_MAP_READ, 0, 0, 0) : nullptr;
    if (address == nullptr)
        return unreadable(path);
    return FileView{static_cast<const std::byte*>(address), static_cast<std::size_t>(size.QuadPart)};
}

void unmapFile(FileView view) {
    if (view.data != nullptr)
        UnmapViewOfFile(view.data);
}

/// To unlock pages that are not locked takes them out of the working set.
void letPagesGo(FileView view) {
    if (view.data != nullptr)
        VirtualUnlock(const_cast<std::byte*>(view.data), view.size);
}

} // namespace limen::platform
