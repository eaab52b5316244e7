// SPDX-License-Identifier: GPL-3.0-or-later
#include "../lineup.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

/// Mesa names its rasteriser threads llvmpipe-0, llvmpipe-1, …
int rasteriserThreads()
{
    int count = 0;
    for (const auto &task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream file(task.path() / "comm");
        std::string name;
        std::getline(file, name);
        count += name.starts_with("llvmpipe-") ? 1 : 0;
    }
    return count;
}

/// Where a display comes from. Mesa reads LP_NUM_THREADS when a display is first initialised, and
/// keeps one display per platform: two platforms give two displays in one process.
enum class Platform { Surfaceless, Device };

EGLDisplay displayOf(Platform platform)
{
    const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (getDisplay == nullptr)
        return EGL_NO_DISPLAY;
    if (platform == Platform::Surfaceless)
        return getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const auto queryDevices
        = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    std::array<EGLDeviceEXT, 16> devices = {};
    EGLint count = 0;
    if (queryDevices == nullptr || !queryDevices(EGLint(devices.size()), devices.data(), &count)
        || count == 0)
        return EGL_NO_DISPLAY;
    // Mesa lists the software device last.
    return getDisplay(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(count) - 1], nullptr);
}

struct Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    void makeCurrent() const
    {
        if (eglGetCurrentContext() != context)
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    }
};

/// A context whose rasteriser has this many threads of its own; 0 means the caller's thread alone.
/// On failure, a message that says what went wrong.
std::variant<Context, QString> contextWith(int threads, Platform platform)
{
    qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
    qputenv("GALLIUM_DRIVER", "llvmpipe");
    qputenv("LP_NUM_THREADS", QByteArray::number(threads));
    const int before = rasteriserThreads();
    Context context;
    context.display = displayOf(platform);
    if (context.display == EGL_NO_DISPLAY || !eglInitialize(context.display, nullptr, nullptr))
        return u"EGL gives no display without a window system"_s;
    eglBindAPI(EGL_OPENGL_ES_API);
    const std::array<EGLint, 3> attributes = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    context.context
        = eglCreateContext(context.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (context.context == EGL_NO_CONTEXT)
        return u"EGL gives no OpenGL ES 3 context"_s;
    context.makeCurrent();
    const QString renderer
        = QString::fromLatin1(reinterpret_cast<const char *>(glGetString(GL_RENDERER)));
    if (!renderer.contains(QLatin1String("llvmpipe")))
        return u"OpenGL runs on %1, not on llvmpipe"_s.arg(renderer);
    const int started = rasteriserThreads() - before;
    if (started != threads)
        return u"asked for %1 rasteriser threads, Mesa started %2"_s.arg(threads).arg(started);
    return context;
}

constexpr const char *vertexShader = R"(#version 300 es
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 colour;
out mediump vec3 smoothColour;
void main() { gl_Position = vec4(position, 0.0, 1.0); smoothColour = colour; }
)";

constexpr const char *fragmentShader = R"(#version 300 es
in mediump vec3 smoothColour;
out mediump vec4 pixel;
void main() { pixel = vec4(smoothColour, 1.0); }
)";

GLuint compiled(GLenum kind, const char *source)
{
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}

struct GlVertex {
    float x, y; ///< clip space
    std::array<std::uint8_t, 4> colour;
};

class Llvmpipe final : public Contender {
public:
    Llvmpipe(const ContenderInfo &info, const Context &context)
        : Contender(info)
        , m_context(context)
    {
        m_context.makeCurrent();
        const GLuint program = glCreateProgram();
        glAttachShader(program, compiled(GL_VERTEX_SHADER, vertexShader));
        glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragmentShader));
        glLinkProgram(program);
        glUseProgram(program);
        glDisable(GL_DITHER);
        glGenFramebuffers(1, &m_framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        glGenRenderbuffers(1, &m_renderbuffer);
        glBindRenderbuffer(GL_RENDERBUFFER, m_renderbuffer);
        glGenBuffers(1, &m_vertexBuffer);
        glBindBuffer(GL_ARRAY_BUFFER, m_vertexBuffer);
        glEnableVertexAttribArray(0);
        glEnableVertexAttribArray(1);
    }

    void load(const Scene &scene) override
    {
        m_context.makeCurrent();
        m_size = scene.size;
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, m_size.width, m_size.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  m_renderbuffer);
        glViewport(0, 0, m_size.width, m_size.height);
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        std::vector<GlVertex> vertices;
        vertices.reserve(scene.triangles.size() * 3);
        for (const Triangle &triangle : scene.triangles) {
            for (const Vertex &vertex : triangle.vertices) {
                // Pixel centres are at half coordinates; y runs upward, as ours.
                const PixelPoint point = pixelOf(vertex);
                vertices.push_back(
                    {clipCoordinate(point.x, m_size.width),
                     clipCoordinate(point.y, m_size.height),
                     {vertex.colour.red(), vertex.colour.green(), vertex.colour.blue(), 255}});
            }
        }
        m_vertexCount = GLsizei(vertices.size());
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(GlVertex)),
                     vertices.data(), GL_STATIC_DRAW);
        const std::uintptr_t colourOffset = offsetof(GlVertex, colour);
        glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(GlVertex), nullptr);
        glVertexAttribPointer(1, 3, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(GlVertex),
                              reinterpret_cast<const void *>(colourOffset));
        glFinish();
    }

    void draw() override
    {
        m_context.makeCurrent();
        glDrawArrays(GL_TRIANGLES, 0, m_vertexCount);
        glFinish();
    }

    Picture picture() override
    {
        m_context.makeCurrent();
        std::vector<std::uint8_t> pixels(std::size_t(m_size.width) * std::size_t(m_size.height)
                                         * 4);
        glReadPixels(0, 0, m_size.width, m_size.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        Picture picture(m_size);
        const std::uint8_t *pixel = pixels.data();
        for (int y = 0; y < m_size.height; ++y) {
            for (int x = 0; x < m_size.width; ++x, pixel += 4)
                picture.set(x, y, qRgb(pixel[0], pixel[1], pixel[2]));
        }
        return picture;
    }

private:
    static float clipCoordinate(int pixel, int extent)
    {
        return float((2.0 * pixel + 1.0) / extent - 1.0);
    }

    Context m_context;
    FrameSize m_size;
    GLuint m_framebuffer = 0;
    GLuint m_renderbuffer = 0;
    GLuint m_vertexBuffer = 0;
    GLsizei m_vertexCount = 0;
};

} // namespace

void addLlvmpipe(Lineup &lineup)
{
    const auto add = [&](int threads, int ownThreads, Platform platform) {
        const QString name
            = u"Mesa llvmpipe, %1 thread%2"_s.arg(threads).arg(threads == 1 ? QString() : u"s"_s);
        const std::variant<Context, QString> made = contextWith(ownThreads, platform);
        if (const QString *reason = std::get_if<QString>(&made)) {
            lineup.absent.push_back({name, *reason});
            return;
        }
        ContenderInfo info;
        info.id = u"llvmpipe-%1"_s.arg(threads);
        info.name = name;
        info.threads = threads;
        lineup.contenders.push_back(std::make_unique<Llvmpipe>(info, *std::get_if<Context>(&made)));
    };
    add(1, 0, Platform::Surfaceless);
    add(2, 2, Platform::Device);
}

} // namespace pixelplumb::bench
