#include "render/interface_drawer.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace sectile::viewer {
namespace {

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

}  // namespace

InterfaceDrawer::InterfaceDrawer() : program_("interface.vert", "interface.frag") {
  glBindVertexArray(layout_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  for (GLuint attribute = 0; attribute < 3; ++attribute) glEnableVertexAttribArray(attribute);
  constexpr GLsizei stride = sizeof(ImDrawVert);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, pos)));
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, uv)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(ImDrawVert, col)));
  glBindVertexArray(0);
}

// The atlas has no texture id before its first upload, and after it was built anew.
void InterfaceDrawer::upload_fonts(ImFontAtlas& fonts) {
  const auto id = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(font_texture_.id()));
  if (fonts.TexID == id) return;
  unsigned char* coverage = nullptr;
  int width = 0, height = 0;
  fonts.GetTexDataAsAlpha8(&coverage, &width, &height);
  glBindTexture(GL_TEXTURE_2D, font_texture_.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, coverage);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  const GLint white_with_coverage[] = {GL_ONE, GL_ONE, GL_ONE, GL_RED};
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, white_with_coverage);
  fonts.SetTexID(id);
}

void InterfaceDrawer::draw(const ImDrawData& interface, int frame_width, int frame_height) {
  upload_fonts(*ImGui::GetIO().Fonts);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, frame_width, frame_height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glActiveTexture(GL_TEXTURE0);
  program_.use();
  program_.set("glyphs", 0);
  program_.set("origin", glm::vec2(interface.DisplayPos.x, interface.DisplayPos.y));
  program_.set("size", glm::vec2(interface.DisplaySize.x, interface.DisplaySize.y));
  glBindVertexArray(layout_.id());
  for (int i = 0; i < interface.CmdListsCount; ++i) {
    const ImDrawList& list = *interface.CmdLists[i];
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                 GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                 GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback && command.UserCallback != ImDrawCallback_ResetRenderState)
        command.UserCallback(&list, &command);
      else if (!command.UserCallback)
        draw_command(interface, command, frame_height);
    }
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

void InterfaceDrawer::draw_command(const ImDrawData& interface, const ImDrawCmd& command,
                                   int frame_height) {
  const ImVec2 origin = interface.DisplayPos, scale = interface.FramebufferScale;
  const float left = std::max((command.ClipRect.x - origin.x) * scale.x, 0.0f);
  const float top = std::max((command.ClipRect.y - origin.y) * scale.y, 0.0f);
  const float right = (command.ClipRect.z - origin.x) * scale.x;
  const float bottom = (command.ClipRect.w - origin.y) * scale.y;
  if (right <= left || bottom <= top) return;
  glScissor(static_cast<GLint>(left), static_cast<GLint>(static_cast<float>(frame_height) - bottom),
            static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
  // Commands of the frame before the first upload do not know the texture's name yet.
  const auto texture = static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
  glBindTexture(GL_TEXTURE_2D, texture ? texture : font_texture_.id());
  glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                           sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                           offset(command.IdxOffset * sizeof(ImDrawIdx)),
                           static_cast<GLint>(command.VtxOffset));
}

}  // namespace sectile::viewer
