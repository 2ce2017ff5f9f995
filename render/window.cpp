#include "render/window.hpp"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <utility>

#include "sim/error.hpp"

namespace waterlight {

namespace {

[[noreturn]] void fail(const std::string& cause) {
    throw WorldError(fmt::format("cannot open a window: {}; `waterlight run` renders without one", cause));
}

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "the window system does not say why";
}

void require_display() {
#ifdef __linux__
    if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
        fail("no display (DISPLAY and WAYLAND_DISPLAY are not set)");
#endif
}

// GLFW, open as long as it lives.
struct Library {
    Library() {
        if (!glfwInit()) fail(last_error());
    }
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

constexpr std::pair<int, Key> keys[] = {
    {GLFW_KEY_SPACE, Key::space}, {GLFW_KEY_PERIOD, Key::period}, {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_F2, Key::f2},       {GLFW_KEY_A, Key::a},           {GLFW_KEY_D, Key::d},
    {GLFW_KEY_E, Key::e},         {GLFW_KEY_P, Key::p},           {GLFW_KEY_Q, Key::q},
    {GLFW_KEY_R, Key::r},         {GLFW_KEY_S, Key::s},           {GLFW_KEY_W, Key::w}};

Key key_of(int code) {
    const auto* found = std::find_if(std::begin(keys), std::end(keys), [&](auto key) { return key.first == code; });
    return found == std::end(keys) ? Key::other : found->second;
}

MouseButton button_of(int code) {
    switch (code) {
        case GLFW_MOUSE_BUTTON_LEFT:
            return MouseButton::left;
        case GLFW_MOUSE_BUTTON_RIGHT:
            return MouseButton::right;
        case GLFW_MOUSE_BUTTON_MIDDLE:
            return MouseButton::middle;
        default:
            return MouseButton::other;
    }
}

}  // namespace

struct Window::Impl {
    Library library;
    GLFWwindow* handle = nullptr;
    std::vector<WindowEvent> events;
    glm::dvec2 mouse{0, 0};  // at the event at hand; GLFW's own answer is where it is by now

    Impl(const std::string& title, glm::ivec2 size);
    ~Impl() { glfwDestroyWindow(handle); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void listen();
    WindowEvent event(WindowEvent::Type type, int modifiers) const;
    static Impl& of(GLFWwindow* window) { return *static_cast<Impl*>(glfwGetWindowUserPointer(window)); }
};

Window::Impl::Impl(const std::string& title, glm::ivec2 size) {
    if (!glfwVulkanSupported()) fail("the window system shows no Vulkan (" + last_error() + ")");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    handle = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (!handle) fail(last_error());
    glfwSetWindowUserPointer(handle, this);
    listen();
}

void Window::Impl::listen() {
    using Type = WindowEvent::Type;
    glfwSetKeyCallback(handle, [](GLFWwindow* window, int key, int, int action, int modifiers) {
        if (action != GLFW_PRESS) return;
        WindowEvent event = of(window).event(Type::key, modifiers);
        event.key = key_of(key);
        event.key_code = key;
        of(window).events.push_back(event);
    });
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* window, int button, int action, int modifiers) {
        WindowEvent event = of(window).event(action == GLFW_PRESS ? Type::press : Type::release, modifiers);
        event.button = button_of(button);
        of(window).events.push_back(event);
    });
    glfwGetCursorPos(handle, &mouse.x, &mouse.y);
    glfwSetCursorPosCallback(handle, [](GLFWwindow* window, double x, double y) {
        of(window).mouse = {x, y};
        of(window).events.push_back(of(window).event(Type::move, 0));
    });
    glfwSetScrollCallback(handle, [](GLFWwindow* window, double, double notches) {
        WindowEvent event = of(window).event(Type::scroll, 0);
        event.scroll = notches;
        of(window).events.push_back(event);
    });
}

// GLFW gives places in units of the screen, of which a pixel may be a part.
WindowEvent Window::Impl::event(WindowEvent::Type type, int modifiers) const {
    glm::ivec2 units, pixels;
    glfwGetWindowSize(handle, &units.x, &units.y);
    glfwGetFramebufferSize(handle, &pixels.x, &pixels.y);
    WindowEvent event{.type = type, .at = mouse * glm::dvec2(pixels) / glm::dvec2(glm::max(units, 1))};
    event.shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    event.control = (modifiers & GLFW_MOD_CONTROL) != 0;
    return event;
}

Window::Window(const std::string& title, glm::ivec2 size) {
    require_display();
    impl_ = std::make_unique<Impl>(title, size);
}

Window::~Window() = default;

glm::ivec2 Window::size() const {
    const bool is_seen = glfwGetWindowAttrib(impl_->handle, GLFW_VISIBLE) != 0;
    if (!is_seen || glfwGetWindowAttrib(impl_->handle, GLFW_ICONIFIED)) return {0, 0};
    glm::ivec2 pixels;
    glfwGetFramebufferSize(impl_->handle, &pixels.x, &pixels.y);
    return pixels;
}

double Window::scale() const {
    glm::vec2 scale;
    glfwGetWindowContentScale(impl_->handle, &scale.x, &scale.y);
    return std::max(1.0F, scale.y);
}

double Window::refresh_hz() const {
    constexpr double common_hz = 60;  // of screens that do not say
    GLFWmonitor* screen = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = screen ? glfwGetVideoMode(screen) : nullptr;
    return mode && mode->refreshRate > 0 ? mode->refreshRate : common_hz;
}

bool Window::closing() const { return glfwWindowShouldClose(impl_->handle); }

bool Window::is_held(Key key) const {
    return std::any_of(std::begin(keys), std::end(keys), [&](auto pair) {
        return pair.second == key && glfwGetKey(impl_->handle, pair.first) == GLFW_PRESS;
    });
}

std::vector<WindowEvent> Window::events(double wait_s) {
    wait_s > 0 ? glfwWaitEventsTimeout(wait_s) : glfwPollEvents();
    return std::exchange(impl_->events, {});
}

gpu::WindowSystem Window::system() const {
    gpu::WindowSystem system;
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (!names) fail("Vulkan shows no pictures in this window system (" + last_error() + ")");
    system.instance_extensions.assign(names, names + count);
    system.presents = [](VkInstance instance, VkPhysicalDevice device, std::uint32_t family) {
        return glfwGetPhysicalDevicePresentationSupport(instance, device, family) == GLFW_TRUE;
    };
    return system;
}

gpu::MakeSurface Window::surface() const {
    return [handle = impl_->handle](VkInstance instance) {
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        if (glfwCreateWindowSurface(instance, handle, nullptr, &surface) != VK_SUCCESS) fail(last_error());
        return surface;
    };
}

GLFWwindow* Window::handle() const { return impl_->handle; }

}  // namespace waterlight
