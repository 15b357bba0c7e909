# Writes OUT: C++ code of the files NAMES, each FOLDER/<name>.ENDING, as FUNCTION().
# Run with cmake -P. Raw strings keep the files' bytes; none may hold )edaha".
set(body "")
list(LENGTH NAMES count)
foreach(name IN LISTS NAMES)
  file(READ "${FOLDER}/${name}.${ENDING}" text)
  string(APPEND body "    BuiltIn{\"${name}\", R\"edaha(${text})edaha\"},\n")
endforeach()
file(WRITE "${OUT}" "// SPDX-License-Identifier: MIT
#include <array>

#include \"style/built_in.h\"

namespace edaha {
namespace {

constexpr std::array<BuiltIn, ${count}> kFiles = {
${body}};

}  // namespace

std::span<const BuiltIn> ${FUNCTION}() { return kFiles; }

}  // namespace edaha
")
