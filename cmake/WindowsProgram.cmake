# limen_windows_program(target): gives a program for Windows its icon, its manifest and its version, and links the libraries of
# the compiler into it. The folder for resources of the program is src/cli/windows.
function(limen_windows_program target)
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
    set(folder ${PROJECT_SOURCE_DIR}/src/cli/windows)
    set(icon ${CMAKE_CURRENT_BINARY_DIR}/limen.ico)
    add_custom_command(OUTPUT ${icon}
        COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/windows/make-icon ${icon}
        DEPENDS ${PROJECT_SOURCE_DIR}/tools/windows/make-icon
        VERBATIM)
    string(REPLACE "." "," LIMEN_VERSION_NUMBERS ${PROJECT_VERSION})
    configure_file(${folder}/limen.rc.in ${CMAKE_CURRENT_BINARY_DIR}/limen.rc @ONLY)
    set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/limen.rc PROPERTIES OBJECT_DEPENDS "${icon};${folder}/limen.manifest")
    target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/limen.rc)
    target_link_options(${target} PRIVATE -static -static-libgcc -static-libstdc++ -municode)
endfunction()
