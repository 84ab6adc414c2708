# Debian packages by CPack: `tools/make-debs`, docs/decisions/0179-debs-by-cpack.md. With LIMEN_DEBIAN (preset `package`) each
# install component is a package, and the shared libraries have components of their own.
set(CPACK_PACKAGE_NAME limen)
set(CPACK_PACKAGE_VENDOR "The Limen authors")
# No mailbox: the project has no address for mail. SECURITY.md and CONTRIBUTING.md name the places for reports.
set(CPACK_PACKAGE_CONTACT "Limen developers <limen@example.invalid>")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL)

# limen_deb(COMPONENT [GROUP g] PACKAGE p SECTION s SUMMARY t DETAILS t [DEPENDS d] [RECOMMENDS r]): one package.
# DEPENDS are those that are no shared libraries.
function(limen_deb component)
    cmake_parse_arguments(ARG "" "GROUP;PACKAGE;SECTION;SUMMARY;DETAILS;DEPENDS;RECOMMENDS" "" ${ARGN})
    set(unit ${component})
    if(ARG_GROUP)
        set(unit ${ARG_GROUP})
    endif()
    string(TOUPPER ${unit} key)
    set(values PACKAGE_NAME "${ARG_PACKAGE}" PACKAGE_SECTION "${ARG_SECTION}" DESCRIPTION "${ARG_SUMMARY}\n${ARG_DETAILS}"
        PACKAGE_DEPENDS "${ARG_DEPENDS}" PACKAGE_RECOMMENDS "${ARG_RECOMMENDS}")
    while(values)
        list(POP_FRONT values name value)
        set(CPACK_DEBIAN_${key}_${name} "${value}" PARENT_SCOPE)
    endwhile()
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
    if(LIMEN_DEBIAN)
        set(folder ${CMAKE_INSTALL_DATADIR}/doc/${ARG_PACKAGE})
        install(FILES ${CMAKE_CURRENT_BINARY_DIR}/copyright DESTINATION ${folder} COMPONENT ${component})
        install(FILES ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz DESTINATION ${folder} COMPONENT ${component} RENAME changelog.Debian.gz)
    endif()
endfunction()

# The files that Debian wants in each package.
if(LIMEN_DEBIAN)
    file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
    string(REGEX REPLACE "^MIT License\n\nCopyright[^\n]*\n\n" "" licence "${licence}")
    string(REGEX REPLACE "\n+$" "" licence "${licence}")
    string(REPLACE "\n\n" "\n.\n" licence "${licence}")
    string(REPLACE "\n" "\n " licence "${licence}")
    configure_file(copyright.in copyright @ONLY)
    string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH, if that is set
    configure_file(changelog.in changelog @ONLY)
    execute_process(COMMAND gzip -9nkf ${CMAKE_CURRENT_BINARY_DIR}/changelog COMMAND_ERROR_IS_FATAL ANY)
    install(CODE "file(GLOB pages \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1/*.1)
        execute_process(COMMAND gzip -9nf \${pages} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
endif()

set(family "Limen draws worlds of interiors and landscape. Rooms are joined by portals.")
if(LIMEN_HAS_PROGRAM)
    limen_deb(program PACKAGE limen SECTION graphics
        SUMMARY "viewer of worlds of interiors and landscape, joined by portals"
        DETAILS "${family}\nThis program opens a window to walk in a world. It also draws pictures, films\nand reports without a window, and verifies and exports dat files."
        DEPENDS "fonts-dejavu-core, libegl1, libgl1" RECOMMENDS "libgl1-mesa-dri, ffmpeg")
endif()
if(LIMEN_DEBIAN)
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
    foreach(key VISIBILITY-LIBRARY DAT-LIBRARY ENGINE-LIBRARY)
        set(CPACK_DEBIAN_${key}_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/triggers)
    endforeach()
    set(visibility liblimen-visibility${LIMEN_SOVERSION})
    set(dat liblimen-dat${LIMEN_SOVERSION})
    limen_deb(visibility-library PACKAGE ${visibility} SECTION libs
        SUMMARY "portal visibility: spaces that an eye sees through portals"
        DETAILS "${family}\nThis library finds the spaces that an eye sees, and the parts of the screen\nthrough which it sees them. It has a C++20 and a C interface.")
    limen_deb(dat-library PACKAGE ${dat} SECTION libs
        SUMMARY "reader and writer of the records of dat files"
        DETAILS "${family}\nThis library reads, verifies and writes the records of their dat files.")
    if(TARGET limen_library_engine)
        set(engine liblimen-engine${LIMEN_SOVERSION})
        limen_deb(engine-library PACKAGE ${engine} SECTION libs
            SUMMARY "frames of worlds of interiors and landscape, drawn with OpenGL"
            DETAILS "${family}\nThis library opens a world of dat files and draws frames of it, without a\nwindow or in the OpenGL context of a program."
            DEPENDS "libegl1, libgl1" RECOMMENDS "libgl1-mesa-dri")
    endif()
    set(same "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
    set(CPACK_COMPONENT_VISIBILITY_GROUP development)
    set(CPACK_COMPONENT_DAT_GROUP development)
    limen_deb(visibility GROUP development PACKAGE liblimen-dev SECTION libdevel
        SUMMARY "headers of the libraries visibility and dat"
        DETAILS "${family}\nThis package has the headers, and the files for CMake and pkg-config."
        DEPENDS "${visibility} ${same}, ${dat} ${same}, libglm-dev")
    list(APPEND CPACK_COMPONENTS_ALL dat)
    if(TARGET limen_library_engine)
        limen_deb(engine PACKAGE liblimen-engine-dev SECTION libdevel
            SUMMARY "headers of the library engine"
            DETAILS "${family}\nThis package has the headers of the library that draws them, and its files\nfor CMake and pkg-config."
            DEPENDS "${engine} ${same}, liblimen-dev ${same}")
    endif()
    find_program(Python_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
    find_package(Python REQUIRED COMPONENTS Interpreter)
    math(EXPR next_python "${Python_VERSION_MINOR} + 1") # the module's file name has the version
    limen_deb(python PACKAGE python3-limen SECTION python
        SUMMARY "portal visibility and dat files from Python"
        DETAILS "${family}\nThis module floods graphs of spaces, and reads and verifies dat files."
        DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_python}), python3-numpy")
    if(TARGET docs)
        set(CPACK_DEBIAN_DOCS_PACKAGE_ARCHITECTURE all)
        limen_deb(docs PACKAGE limen-doc SECTION doc
            SUMMARY "manual, format reference and pages of the interfaces"
            DETAILS "${family}\nThis package has the manual, the reference of the formats, and the pages of the\nprogramming interfaces, as HTML.")
    endif()
endif()
include(CPack)
