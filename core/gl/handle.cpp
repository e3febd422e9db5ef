// SPDX-License-Identifier: Apache-2.0
#include "core/gl/handle.h"

#include <epoxy/gl.h>

namespace burin::gl {

void TextureTraits::Delete(std::uint32_t id) { glDeleteTextures(1, &id); }
void SamplerTraits::Delete(std::uint32_t id) { glDeleteSamplers(1, &id); }
void BufferTraits::Delete(std::uint32_t id) { glDeleteBuffers(1, &id); }
void FramebufferTraits::Delete(std::uint32_t id) { glDeleteFramebuffers(1, &id); }
void VertexArrayTraits::Delete(std::uint32_t id) { glDeleteVertexArrays(1, &id); }
void ProgramTraits::Delete(std::uint32_t id) { glDeleteProgram(id); }

}  // namespace burin::gl
