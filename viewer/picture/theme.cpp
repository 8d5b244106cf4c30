#include "picture/theme.h"

namespace sectile::viewer {
namespace {

constexpr Colour hex(std::uint32_t rgb, float alpha = 1) {
  return {static_cast<float>(rgb >> 16 & 255) / 255, static_cast<float>(rgb >> 8 & 255) / 255,
          static_cast<float>(rgb & 255) / 255, alpha};
}

// What both themes share.
Theme meaning() {
  Theme t;
  t.a = hex(0x2f7fc1, 0.42f);
  t.b = hex(0xe58a1f, 0.42f);
  t.a_out_b = hex(0x0f6db3);
  t.a_in_b = hex(0x6cc0ee);
  t.b_out_a = hex(0xd2601a);
  t.b_in_a = hex(0xf2b53c);
  t.a_on_b_plus = hex(0x009e73);
  t.a_on_b_minus = hex(0x7ad0b0);
  t.b_on_a_plus = hex(0xb4539a);
  t.b_on_a_minus = hex(0xe3a3cc);
  t.cut = hex(0x00a37a);
  t.null_edge = hex(0x8a2fbf);
  t.null_edge_above = hex(0xcf9df2);
  t.null_edge_below = hex(0x4d1478);
  t.handle_x = hex(0xd6405a);
  t.handle_y = hex(0x4f9e35);
  t.handle_z = hex(0x3b78e0);
  t.surroundings.axis_x = t.handle_x;
  t.surroundings.axis_y = t.handle_y;
  t.surroundings.axis_z = t.handle_z;
  return t;
}

Theme light() {
  Theme t = meaning();
  t.surroundings.background_top = hex(0xf6f8fa);
  t.surroundings.background_bottom = hex(0xd5dce3);
  t.surroundings.grid = hex(0x7d8894, 0.45f);
  t.surroundings.edge = hex(0x1b2027);
  t.result = hex(0xc9ccd1);
  t.neutral = hex(0xb3bac3);
  t.coincident = hex(0x14181d);
  t.contact = hex(0xffdf33);
  t.contact_segment = hex(0x8c7a00);
  t.step = hex(0xe0115f);
  t.selection = t.surroundings.outline = hex(0xf0319b);
  t.hover = hex(0xf58cc6);
  t.handle_active = hex(0xffc21a);
  t.text = hex(0x1b2027);
  t.text_halo = hex(0xffffff, 0.8f);
  return t;
}

Theme dark() {
  Theme t = meaning();
  t.surroundings.background_top = hex(0x2b3038);
  t.surroundings.background_bottom = hex(0x16191d);
  t.surroundings.grid = hex(0x8b97a5, 0.32f);
  t.surroundings.edge = hex(0xdfe5ec);
  t.result = hex(0xb9bec6);
  t.neutral = hex(0x98a1ac);
  t.coincident = hex(0xffffff);
  t.contact = hex(0xffd21f);
  t.contact_segment = hex(0xd6b400);
  t.step = hex(0xff3d86);
  t.selection = t.surroundings.outline = hex(0xff5db4);
  t.hover = hex(0xb8578d);
  t.handle_active = hex(0xffd24a);
  t.null_edge = hex(0xb266e6);
  t.null_edge_below = hex(0x7433ad);
  t.null_edge_above = hex(0xcf9df2);
  t.text = hex(0xe8ecf1);
  t.text_halo = hex(0x101316, 0.8f);
  return t;
}

}  // namespace

const Theme& theme(bool dark_one) {
  static const Theme themes[] = {light(), dark()};
  return themes[dark_one ? 1 : 0];
}

Colour with_alpha(Colour colour, float alpha) {
  return {glm::vec3(colour), alpha};
}

Colour fainter(Colour colour, const Theme& theme, float amount) {
  const Surroundings& s = theme.surroundings;
  const glm::vec3 back = glm::vec3(s.background_top + s.background_bottom) * 0.5f;
  return {glm::mix(glm::vec3(colour), back, amount), colour.a};
}

}  // namespace sectile::viewer
