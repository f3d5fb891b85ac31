# Targets maclint_json and maclint_cli11: header-only libraries of the system, or those in MACLINT_HEADERS.
add_library(maclint_json INTERFACE)
add_library(maclint_cli11 INTERFACE)

if(MACLINT_HEADERS)
  foreach(header nlohmann/json.hpp CLI/CLI.hpp)
    if(NOT EXISTS "${MACLINT_HEADERS}/${header}")
      message(FATAL_ERROR "MACLINT_HEADERS names '${MACLINT_HEADERS}', where ${header} is missing. "
        "Fill a folder with: python3 packaging/fetch_sources.py build/sources")
    endif()
  endforeach()
  target_include_directories(maclint_json SYSTEM INTERFACE "${MACLINT_HEADERS}")
  target_include_directories(maclint_cli11 SYSTEM INTERFACE "${MACLINT_HEADERS}")
else()
  find_package(nlohmann_json REQUIRED)
  find_package(CLI11 REQUIRED)
  target_link_libraries(maclint_json INTERFACE nlohmann_json::nlohmann_json)
  target_link_libraries(maclint_cli11 INTERFACE CLI11::CLI11)
endif()
