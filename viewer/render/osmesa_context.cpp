// Mesa's off-screen context. The library is opened at run time, so that the program needs it only
// when there is no window.
#include <dlfcn.h>

#include <stdexcept>
#include <string>

#include "render/current_context.h"

namespace sectile::viewer {
namespace {

// From GL/osmesa.h, which cannot stand beside glad's header.
constexpr int osmesa_rgba = 0x1908, osmesa_format = 0x22, osmesa_depth_bits = 0x30,
              osmesa_stencil_bits = 0x31, osmesa_profile = 0x33, osmesa_core_profile = 0x34,
              osmesa_major_version = 0x36, osmesa_minor_version = 0x37;
constexpr unsigned gl_unsigned_byte = 0x1401;

class Library {
 public:
  static const Library& get() {
    static const Library library;
    return library;
  }
  static void* open() { return dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL); }

  void* (*create)(const int* attributes, void* share) = nullptr;
  void (*destroy)(void* context) = nullptr;
  unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width,
                                int height) = nullptr;
  void (*(*get_function)(const char* name))() = nullptr;

 private:
  Library() : handle_(open()) {
    if (!handle_) throw std::runtime_error("libOSMesa.so.8 is not installed");
    find(create, "OSMesaCreateContextAttribs");
    find(destroy, "OSMesaDestroyContext");
    find(make_current, "OSMesaMakeCurrent");
    find(get_function, "OSMesaGetProcAddress");
  }

  template <typename FunctionPointer>
  void find(FunctionPointer& function, const char* name) {
    function = reinterpret_cast<FunctionPointer>(dlsym(handle_, name));
    if (!function) throw std::runtime_error(std::string("libOSMesa.so.8 has no ") + name);
  }

  void* handle_;  // never closed: Mesa's threads may still run in it
};

class OsmesaContext final : public TurnTakingContext {
 public:
  OsmesaContext(int width, int height, float scale)
      : width_(width), height_(height), scale_(scale) {
    check_size(width, height);
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    const int attributes[] = {osmesa_format,
                              osmesa_rgba,
                              osmesa_depth_bits,
                              24,
                              osmesa_stencil_bits,
                              8,
                              osmesa_profile,
                              osmesa_core_profile,
                              osmesa_major_version,
                              3,
                              osmesa_minor_version,
                              3,
                              0};
    context_ = Library::get().create(attributes, nullptr);
    if (!context_) throw std::runtime_error("OSMesa gives no OpenGL 3.3 context");
  }
  ~OsmesaContext() override {
    retire();
    Library::get().destroy(context_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  int width() const override { return width_; }
  int height() const override { return height_; }
  float scale() const override { return scale_; }
  void present() override {}

 protected:
  void bind() override {
    if (!Library::get().make_current(context_, pixels_.data(), gl_unsigned_byte, width_, height_))
      throw std::runtime_error("The OSMesa context cannot be made current");
  }
  void unbind() override { Library::get().make_current(nullptr, nullptr, 0, 0, 0); }
  Loader loader() const override { return Library::get().get_function; }

 private:
  int width_, height_;
  float scale_;
  std::vector<std::uint8_t> pixels_;
  void* context_ = nullptr;
};

}  // namespace

bool has_osmesa() {
  static const bool has = Library::open() != nullptr;
  return has;
}

std::unique_ptr<GraphicsContext> make_osmesa_context(int width, int height, float scale) {
  return std::make_unique<OsmesaContext>(width, height, scale);
}

}  // namespace sectile::viewer
