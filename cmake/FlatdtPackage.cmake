# Installation. Each component (checker, ref, testing, campaign) can be installed alone, from a configuration of its folder
# or of the whole project, into one prefix: they share flatdt-config.cmake, which offers the libraries that are there.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(flatdt_cmake_folder "${CMAKE_INSTALL_LIBDIR}/cmake/flatdt")

# flatdt_install_component(NAME [TARGETS TARGET...] [PROGRAMS TARGET...] [HEADERS FOLDER...] [MANUALS FILE...] [DATA FILE...]
#                          [COMPLETIONS FILE...] [PKG_CONFIG NAME...])
#   HEADERS      folders, installed with their names below include/
#   COMPLETIONS  PROGRAM.bash and _PROGRAM (zsh)
#   PKG_CONFIG   cmake/NAME.in beside this file
function(flatdt_install_component name)
  cmake_parse_arguments(install "" "" "TARGETS;PROGRAMS;HEADERS;MANUALS;DATA;COMPLETIONS;PKG_CONFIG" ${ARGN})
  if(install_TARGETS)
    install(TARGETS ${install_TARGETS} EXPORT flatdt-${name}
      ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT ${name}
      LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT ${name} NAMELINK_COMPONENT ${name}
      INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
    install(EXPORT flatdt-${name} NAMESPACE flatdt:: FILE flatdt-${name}-targets.cmake
      DESTINATION "${flatdt_cmake_folder}" COMPONENT ${name})
  endif()
  if(install_PROGRAMS)
    install(TARGETS ${install_PROGRAMS} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT ${name})
  endif()
  foreach(folder IN LISTS install_HEADERS)
    install(DIRECTORY "${folder}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT ${name}
      FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
  endforeach()
  foreach(manual IN LISTS install_MANUALS)
    install(FILES "${manual}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT ${name})
  endforeach()
  if(install_DATA)
    install(FILES ${install_DATA} DESTINATION "${CMAKE_INSTALL_DATADIR}/flatdt" COMPONENT ${name})
  endif()
  foreach(file IN LISTS install_COMPLETIONS)
    get_filename_component(program "${file}" NAME)
    if(program MATCHES "^_")
      install(FILES "${file}" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" COMPONENT ${name})
    else()
      string(REGEX REPLACE "\\.bash$" "" program "${program}")
      install(FILES "${file}" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME "${program}"
        COMPONENT ${name})
    endif()
  endforeach()
  # Relative, so that the tree can be installed or moved anywhere.
  file(RELATIVE_PATH flatdt_prefix_from_pc "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  foreach(file IN LISTS install_PKG_CONFIG)
    configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${file}.in" "${CMAKE_CURRENT_BINARY_DIR}/${file}" @ONLY)
    install(FILES "${CMAKE_CURRENT_BINARY_DIR}/${file}" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT ${name})
  endforeach()
  if(install_TARGETS)
    write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/flatdt-config-version.cmake"
      VERSION "${PROJECT_VERSION}" COMPATIBILITY SameMinorVersion)
    install(FILES "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/flatdt-config.cmake"
      "${CMAKE_CURRENT_BINARY_DIR}/flatdt-config-version.cmake"
      DESTINATION "${flatdt_cmake_folder}" COMPONENT ${name})
  endif()
endfunction()
