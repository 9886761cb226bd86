# Targets: format (rewrite), format-check (fail on a difference). All C++ sources that git tracks.
find_program(FLATDT_CLANG_FORMAT NAMES clang-format-14 clang-format)
if(FLATDT_CLANG_FORMAT)
  set(flatdt_list_sources "git ls-files -co --exclude-standard -- '*.cpp' '*.hpp'")
  add_custom_target(format
    COMMAND sh -c "${flatdt_list_sources} | xargs ${FLATDT_CLANG_FORMAT} -i"
    WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}" VERBATIM)
  add_custom_target(format-check
    COMMAND sh -c "${flatdt_list_sources} | xargs ${FLATDT_CLANG_FORMAT} --dry-run --Werror"
    WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}" VERBATIM)
endif()
