# Writes each of FILES (resources/exports) as a C++ string into OUT.
set(out "// Generated from resources/exports by embed_targets.cmake.\n#include \"core/exporters/engines/embedded_targets.h\"\nnamespace relievo {\nconst std::vector<EmbeddedTarget>& embeddedTargets()\n{\n    static const std::vector<EmbeddedTarget> targets = {\n")
foreach(file IN LISTS FILES)
  file(READ "${file}" text)
  get_filename_component(name "${file}" NAME)
  string(APPEND out "{\"${name}\", R\"target(${text})target\"},\n")
endforeach()
string(APPEND out "};\n    return targets;\n}\n}\n")
file(WRITE "${OUT}" "${out}")
