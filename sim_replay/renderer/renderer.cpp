// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/renderer.h"

#include "sim_replay/renderer/frame_truth.h"
#include "sim_replay/renderer/gl_context.h"
#include "sim_replay/renderer/gl_target.h"
#include "sim_replay/renderer/lens.h"
#include "sim_replay/renderer/scene.h"
#include "sim_replay/renderer/sensor.h"

namespace hindsight {
namespace {

/// All that must be made and destroyed with the context current.
struct Drawing {
  Scene scene;
  Sensor sensor;
  GlImage light, depth, objects;
  GlTarget plain, with_objects;

  Drawing(const World& world, const RenderCamera& camera, const Lens& lens, std::uint64_t seed)
      : scene(world),
        sensor(camera, lens, seed),
        light(GL_RGBA16F, lens.wide.width_px, lens.wide.height_px, GL_LINEAR),
        depth(GL_DEPTH_COMPONENT32F, lens.wide.width_px, lens.wide.height_px, GL_NEAREST),
        objects(GL_R16UI, lens.wide.width_px, lens.wide.height_px, GL_NEAREST),
        plain({&light}, &depth),
        with_objects({&light, &objects}, &depth) {}
};

}  // namespace

struct Renderer::Parts {
  World world;
  RenderCamera camera;
  Lens lens;
  GlContext context;
  std::unique_ptr<Drawing> drawing;
  WideTruth wide;
  RenderedFrame frame;

  Parts(const World& world_, const RenderCamera& camera_, std::uint64_t seed)
      : world(world_), camera(camera_), lens(camera_) {
    const GlContext::Current current(context);
    drawing = std::make_unique<Drawing>(world, camera, lens, seed);
    frame.bgr.resize(3 * lens.directions.size());
    wide.objects.resize(static_cast<std::size_t>(lens.wide.width_px * lens.wide.height_px));
    wide.depths.resize(wide.objects.size());
  }
  ~Parts() {
    const GlContext::Current current(context);
    drawing.reset();
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void read_truth() {
    const auto bytes = [](const auto& values) {
      return static_cast<GLsizei>(values.size() * sizeof(values[0]));
    };
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(drawing->objects.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_SHORT, bytes(wide.objects),
                      wide.objects.data());
    glGetTextureImage(drawing->depth.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, bytes(wide.depths),
                      wide.depths.data());
    fill_truth(world, lens, wide, frame);
  }

  void drop_truth() {
    frame.labels.clear();
    frame.objects.clear();
    frame.depth_m.clear();
  }
};

Renderer::Renderer(const World& world, const RenderCamera& camera, std::uint64_t seed)
    : parts_(std::make_unique<Parts>(world, camera, seed)) {}

Renderer::~Renderer() = default;

const RenderedFrame& Renderer::render(const BodyPose& X_WB, const BodyPose& X_WB_before,
                                      double frame_interval_s, double time_s, bool truth) {
  Parts& parts = *parts_;
  const GlContext::Current current(parts.context);
  Drawing& drawing = *parts.drawing;
  const CameraPose now = camera_pose(parts.camera, X_WB), before = camera_pose(parts.camera, X_WB_before);
  glBindFramebuffer(GL_FRAMEBUFFER, (truth ? drawing.with_objects : drawing.plain).id());
  drawing.scene.draw(SceneView(now, parts.lens.wide), parts.lens.wide, time_s);
  drawing.sensor.take(drawing.light, drawing.depth, {now, before, frame_interval_s}, parts.frame.bgr);
  parts.frame.exposure_s = drawing.sensor.exposure_s();
  parts.frame.gain = drawing.sensor.gain();
  if (truth) {
    parts.read_truth();
  } else {
    parts.drop_truth();
  }
  return parts.frame;
}

}  // namespace hindsight
