# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
# Writes the texts of shaders as a C++ table.
# usage: cmake -D OUTPUT=PATH -D ROOT=FOLDER -D FILES=LIST -P EmbedShaders.cmake
set(rows "")
set(count 0)
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} text)
  string(APPEND rows "    {\"${file}\", R\"glsl(${text})glsl\"},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${OUTPUT} "// Made of shaders/ by cmake/EmbedShaders.cmake.
#include \"shader_text.hpp\"

namespace ocean::gl {

const EmbeddedShader kEmbeddedShaders[] = {
${rows}};
const int kEmbeddedShaderCount = ${count};

}  // namespace ocean::gl
")
