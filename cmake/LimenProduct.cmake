# Libraries for other projects. Each is made of the objects of its rooms, and has copies of their public headers with
# includes of the form "limen/room/Header.h", so that a user's include path gains the one name `limen`. The copies in the
# build folder are those that are installed.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(LIMEN_INCLUDE ${PROJECT_BINARY_DIR}/include)

# limen_public_header(out source target-path): copies one header, with its includes rewritten.
function(limen_public_header out source path)
    set(copy ${LIMEN_INCLUDE}/limen/${path})
    add_custom_command(OUTPUT ${copy}
        COMMAND ${CMAKE_COMMAND} -D SOURCE=${source} -D COPY=${copy} -P ${PROJECT_SOURCE_DIR}/cmake/PublicHeader.cmake
        DEPENDS ${source} ${PROJECT_SOURCE_DIR}/cmake/PublicHeader.cmake
        VERBATIM
        COMMENT "")
    set(${out} ${${out}} ${copy} PARENT_SCOPE)
endfunction()

# limen_product(name DESCRIPTION d ROOMS r... HEADERS h... [COMMON_HEADERS h...] [C_HEADER h] [NAMES map] [REQUIRES target...] [LINKS target...]
# [PKG_CONFIG_REQUIRES p...] [PKG_CONFIG_PRIVATE p...]): the library limen-name with the alias limen::name. COMMON_HEADERS: those that
# another library has, too; with LIMEN_DEBIAN they and the CMake file are in the package of that library alone. NAMES: the names that a
# shared one exports. REQUIRES are part of its interface; LINKS are needed to link a static one. BUILD_SHARED_LIBS chooses the kind.
function(limen_product name)
    cmake_parse_arguments(ARG "" "DESCRIPTION;C_HEADER;NAMES" "ROOMS;HEADERS;COMMON_HEADERS;REQUIRES;LINKS;PKG_CONFIG_REQUIRES;PKG_CONFIG_PRIVATE" ${ARGN})
    if(NOT ARG_NAMES)
        set(ARG_NAMES exported-names.map)
    endif()
    set(names ${PROJECT_SOURCE_DIR}/cmake/${ARG_NAMES})
    set(target limen_library_${name})
    set(objects)
    foreach(room IN LISTS ARG_ROOMS)
        list(APPEND objects $<TARGET_OBJECTS:limen_${room}>)
    endforeach()
    set(headers)
    foreach(header IN LISTS ARG_HEADERS)
        limen_public_header(headers ${PROJECT_SOURCE_DIR}/src/${header} ${header})
    endforeach()
    set(common_headers ${LIMEN_INCLUDE}/limen/version.h)
    foreach(header IN LISTS ARG_COMMON_HEADERS)
        limen_public_header(common_headers ${PROJECT_SOURCE_DIR}/src/${header} ${header})
    endforeach()
    if(ARG_C_HEADER) # limen/NAME.h
        limen_public_header(headers ${PROJECT_SOURCE_DIR}/src/${ARG_C_HEADER} ${name}.h)
    endif()
    add_library(${target} ${objects})
    add_library(limen::${name} ALIAS ${target})
    target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${LIMEN_INCLUDE} FILES ${headers}
        FILE_SET common_headers TYPE HEADERS BASE_DIRS ${LIMEN_INCLUDE} FILES ${common_headers})
    add_custom_target(${target}_headers DEPENDS ${headers} ${common_headers}) # a user's source may be compiled before the library
    add_dependencies(${target} ${target}_headers)
    target_compile_features(${target} INTERFACE cxx_std_20)
    target_link_libraries(${target} PUBLIC ${ARG_REQUIRES} PRIVATE ${ARG_LINKS})
    set_target_properties(${target} PROPERTIES OUTPUT_NAME limen-${name} EXPORT_NAME ${name} LINKER_LANGUAGE CXX SYSTEM ON
        VERSION ${PROJECT_VERSION} SOVERSION ${LIMEN_SOVERSION})
    if(BUILD_SHARED_LIBS)
        target_compile_definitions(${target} INTERFACE LIMEN_SHARED)
    endif()
    if(BUILD_SHARED_LIBS AND NOT WIN32) # a DLL exports marked names alone
        # Names of the standard library that templates bring along stay local.
        target_link_options(${target} PRIVATE -Wl,--version-script=${names} -Wl,-z,defs)
        set_target_properties(${target} PROPERTIES LINK_DEPENDS ${names})
    endif()
    if(LIMEN_SANITIZE) # the sanitizers' runtime is in the program
        target_link_options(${target} PRIVATE -fsanitize=${LIMEN_SANITIZE} -Wl,-z,undefs)
    endif()
    if(LIMEN_INSTALL)
        limen_install_product(${name} "${ARG_DESCRIPTION}" "${ARG_PKG_CONFIG_REQUIRES}" "${ARG_PKG_CONFIG_PRIVATE}" "${ARG_COMMON_HEADERS}")
    endif()
endfunction()

function(limen_install_product name description requires private common_headers)
    set(target limen_library_${name})
    set(common ${name}) # the component of files that several libraries have
    if(LIMEN_DEBIAN AND common_headers)
        set(common common-files) # in no package: the other library's component has them
    endif()
    set(config ${CMAKE_INSTALL_LIBDIR}/cmake/limen)
    set(library ${name}) # a distribution has the library in a package without the headers
    if(LIMEN_DEBIAN)
        set(library ${name}-library)
    endif()
    install(TARGETS ${target} EXPORT limen-${name}-targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${library} NAMELINK_COMPONENT ${name}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${name}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${name}
        FILE_SET common_headers DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${common})
    install(EXPORT limen-${name}-targets NAMESPACE limen:: DESTINATION ${config} COMPONENT ${name})
    configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/limen-config.cmake.in ${PROJECT_BINARY_DIR}/limen-config.cmake INSTALL_DESTINATION ${config})
    write_basic_package_version_file(${PROJECT_BINARY_DIR}/limen-config-version.cmake COMPATIBILITY ${LIMEN_COMPATIBILITY})
    install(FILES ${PROJECT_BINARY_DIR}/limen-config.cmake ${PROJECT_BINARY_DIR}/limen-config-version.cmake DESTINATION ${config} COMPONENT ${common})

    # A path from the .pc file, so that an installed copy may move.
    set(pkgconfig ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
    file(RELATIVE_PATH to_prefix /${pkgconfig} /)
    list(JOIN requires " " requires)
    list(JOIN private " " private)
    set(cflags "")
    set(libs_private "")
    if(BUILD_SHARED_LIBS)
        set(cflags " -DLIMEN_SHARED")
        set(private "") # a user of the shared library needs no .pc file of these
    else()
        # A static library needs its own requirements and the C++ library in each link.
        set(requires "${requires} ${private}")
        set(private "")
        set(libs_private " -lstdc++ -lm")
    endif()
    configure_file(${PROJECT_SOURCE_DIR}/cmake/limen.pc.in ${PROJECT_BINARY_DIR}/limen-${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/limen-${name}.pc DESTINATION ${pkgconfig} COMPONENT ${name})
endfunction()

# While the major version is 0, a minor version may change the interface (docs/api-stability.md).
if(PROJECT_VERSION_MAJOR EQUAL 0)
    set(LIMEN_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    set(LIMEN_COMPATIBILITY SameMinorVersion)
else()
    set(LIMEN_SOVERSION ${PROJECT_VERSION_MAJOR})
    set(LIMEN_COMPATIBILITY SameMajorVersion)
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/version.h.in ${LIMEN_INCLUDE}/limen/version.h @ONLY)
