# find_package(flatdt [COMPONENTS checker ref testing]); without COMPONENTS: all that are installed.
#   flatdt::checker    the checker, C++            flatdt::checker_c  the same through C, libflatdt_checker.so
#   flatdt::ref        the reference
#   flatdt::testing    generators for RapidCheck and matchers for GoogleTest; uses the other two
include(CMakeFindDependencyMacro)

set(flatdt_components checker ref testing)
if(NOT flatdt_FIND_COMPONENTS)
  foreach(component IN LISTS flatdt_components)
    if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/flatdt-${component}-targets.cmake")
      list(APPEND flatdt_FIND_COMPONENTS ${component})
    endif()
  endforeach()
endif()

# What a component uses is loaded before it.
set(flatdt_wanted ${flatdt_FIND_COMPONENTS})
if("testing" IN_LIST flatdt_wanted)
  list(PREPEND flatdt_wanted checker ref)
  list(REMOVE_DUPLICATES flatdt_wanted)
endif()
foreach(component IN LISTS flatdt_wanted)
  if(NOT EXISTS "${CMAKE_CURRENT_LIST_DIR}/flatdt-${component}-targets.cmake")
    list(REMOVE_ITEM flatdt_wanted ${component})
    if(flatdt_FIND_REQUIRED_${component} OR NOT component IN_LIST flatdt_FIND_COMPONENTS)
      set(flatdt_FOUND FALSE)
      set(flatdt_NOT_FOUND_MESSAGE "the component ${component} of flatdt is not installed")
      return()
    endif()
  endif()
endforeach()

if(NOT TARGET flatdt::gmp)
  find_path(FLATDT_GMP_INCLUDE_DIR gmpxx.h)
  find_library(FLATDT_GMP_LIBRARY gmp)
  find_library(FLATDT_GMPXX_LIBRARY gmpxx)
  if(NOT FLATDT_GMP_INCLUDE_DIR OR NOT FLATDT_GMP_LIBRARY OR NOT FLATDT_GMPXX_LIBRARY)
    set(flatdt_FOUND FALSE)
    set(flatdt_NOT_FOUND_MESSAGE "flatdt needs GMP with its C++ interface (gmpxx.h)")
    return()
  endif()
  add_library(flatdt::gmp INTERFACE IMPORTED)
  set_target_properties(flatdt::gmp PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${FLATDT_GMP_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${FLATDT_GMPXX_LIBRARY};${FLATDT_GMP_LIBRARY}")
endif()

if("testing" IN_LIST flatdt_wanted)
  find_dependency(GTest CONFIG)
  find_dependency(rapidcheck CONFIG)
endif()
foreach(component IN LISTS flatdt_wanted)
  include("${CMAKE_CURRENT_LIST_DIR}/flatdt-${component}-targets.cmake")
  set(flatdt_${component}_FOUND TRUE)
endforeach()
