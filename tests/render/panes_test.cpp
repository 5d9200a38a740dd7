// Two panes that differ: what one of them needs is not thrown away for the other.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/pose.h"
#include "render/gl/driver_limits.h"
#include "tests/render/mesh_support.h"
#include <epoxy/gl.h>

using namespace relievo;
using namespace relievo::test;

namespace {

// Counts what goes to the driver while it lives; functions of OpenGL are pointers in libepoxy, which must have been called before.
class UploadCounter {
public:
    UploadCounter() : m_buffer(epoxy_glBufferData), m_image(epoxy_glTexImage2D)
    {
        s_of = this;
        epoxy_glBufferData = [](GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
            s_of->bytes += usage == GL_STREAM_DRAW ? 0 : size; // not the pose, which is small
            s_of->m_buffer(target, size, data, usage);
        };
        epoxy_glTexImage2D = [](GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLint border, GLenum format,
                                 GLenum type, const void* data) {
            ++s_of->images;
            s_of->m_image(target, level, internal, width, height, border, format, type, data);
        };
    }
    ~UploadCounter() { epoxy_glBufferData = m_buffer, epoxy_glTexImage2D = m_image; }

    GLsizeiptr bytes = 0;
    int images = 0;

private:
    static inline UploadCounter* s_of = nullptr;
    decltype(epoxy_glBufferData) m_buffer;
    decltype(epoxy_glTexImage2D) m_image;
};

// Draws panes of a State and says how many triangles that took.
class Drawing {
public:
    unsigned operator()(const State& state, std::size_t pane, Resources resources)
    {
        EXPECT_TRUE(m_framebuffer.resize(96, 72));
        GLuint query = 0, count = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_PRIMITIVES_GENERATED, query);
        const auto drawn
            = m_renderer.draw({state, pane, resources, {.framebuffer = m_framebuffer.handle(), .width = 96, .height = 72}, "shaded"});
        EXPECT_TRUE(drawn) << (drawn ? "" : message(drawn.error()));
        glEndQuery(GL_PRIMITIVES_GENERATED);
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
        glDeleteQueries(1, &query);
        return count;
    }

private:
    Renderer m_renderer;
    Framebuffer m_framebuffer;
};

// A sphere that a morph target, at rest half on, makes flatter.
Resources morphing(Resources resources)
{
    Mesh mesh = *resources.mesh;
    const auto deformation = std::make_shared<Deformation>();
    deformation->influences.resize(mesh.vertices.size());
    deformation->joints.resize(1);
    MorphTarget target{"flatter", -1, 0.5f, {}};
    for (const Vertex& vertex : mesh.vertices) {
        MorphDelta delta;
        delta.position.y = -0.8f * vertex.position.y;
        target.deltas.push_back(delta);
    }
    deformation->targets.push_back(std::move(target));
    mesh.deformation = deformation;
    resources.mesh = std::make_shared<const Mesh>(std::move(mesh));
    return resources;
}

} // namespace

TEST(Panes, UploadNothingForEachOther)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    struct Difference {
        const char* key;
        Value a, b;
    };
    for (const Difference& difference : {Difference{"silhouettes", 1, 2}, {"wrap", 0, 1}, {"shadowMapSize", 256, 128}})
        for (const bool moves : {false, true}) {
            State state = stateOn("sphere");
            state.parameters.objectShadows = true;
            state.panes = {Pane{"cell-cone", {{difference.key, difference.a}}}, Pane{"cell-cone", {{difference.key, difference.b}}}};
            state.slots[std::size_t(MapKind::Normal)] = {};
            Resources resources = moves ? morphing(resourcesOf(state)) : resourcesOf(state);
            Drawing draw;
            for (const std::size_t pane : {0u, 1u})
                draw(state, pane, resources);
            UploadCounter counter;
            for (const std::size_t pane : {0u, 1u, 0u, 1u})
                draw(state, pane, resources);
            EXPECT_EQ(counter.bytes, 0) << difference.key << moves;
            EXPECT_EQ(counter.images, 0) << difference.key << moves;
        }
}

// A shadow map is drawn when what it shows changes, not for another pane nor for how the picture is lit.
TEST(Panes, KeepTheirShadowMaps)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = stateOn("torus");
    state.panes = {Pane{"cell-cone", {}}, Pane{"pyramid", {}}};
    Resources resources = resourcesOf(state);
    Drawing draw;
    const unsigned alone = draw(state, 0, resources);
    Parameters& p = state.parameters;
    p.objectShadows = true;
    EXPECT_GT(draw(state, 0, resources), alone);
    EXPECT_GT(draw(state, 1, resources), alone);
    for (const std::size_t pane : {0u, 1u, 0u})
        EXPECT_EQ(draw(state, pane, resources), alone);
    p.exposure = 1.f, p.tint.x = 0.5f, p.lightIntensity = 2.f, p.environmentYaw = 20.f, p.shadowStrength = 0.5f, p.roughness = 0.4f;
    EXPECT_EQ(draw(state, 0, resources), alone);
    for (const auto& change : std::initializer_list<void (*)(Parameters&)>{[](Parameters& q) { q.lightYaw += 10.f; },
             [](Parameters& q) { q.lightPitch += 10.f; }, [](Parameters& q) { q.depth *= 2.f; }, [](Parameters& q) { q.offsetU = 0.3f; },
             [](Parameters& q) { q.shadowMapSize = 512; }, [](Parameters& q) { q.silhouettes = Silhouettes::Quadric; }}) {
        change(p);
        EXPECT_GT(draw(state, 0, resources), alone);
    }
}
