// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What shaders find of a pixel's neighbours in one look is what two looks find of the pixel itself.
#include "Props.h"
#include "Stage.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowServices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

//------------------------------------------------------------------------------
// The difference of the normals; 10 if anything else differs.
const char* const NeighbourShader = R"(//VTK::System::Dec
//VTK::Output::Dec
//SoftShadows::Include vtkShadowReceiver

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Receiver receiver;
  bool receives = loadReceiver(pixel, receiver);
  vec3 positionVs;
  vec3 normalVs;
  bool isSame = loadNeighbour(pixel, positionVs, normalVs) == receives &&
    positionVs == receiver.positionVs;
  gl_FragData[0] = vec4(isSame ? length(normalVs - receiver.normalVs) : 10.0);
}
)";

//------------------------------------------------------------------------------
/// Its visibility is what the shader writes.
class NeighbourPass : public vtkSoftShadowPass
{
public:
  static NeighbourPass* New();
  vtkTypeMacro(NeighbourPass, vtkSoftShadowPass);

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window);
    this->Shader.ReleaseGraphicsResources(window);
  }

protected:
  vtkSoftShadowRequirements GetRequirements() const override
  {
    vtkSoftShadowRequirements requirements;
    requirements.EmitterMap = false;
    requirements.Proof = vtkSoftShadowRequirements::PROVES_NOTHING;
    return requirements;
  }

  void Add(const vtkSoftShadowServices& services) override
  {
    ASSERT_TRUE(this->Shader.Use(services.Window));
    services.SetReceiverUniforms(this->Shader.GetProgram());
    services.DrawMarked(this->Shader);
    services.Receivers->Deactivate();
  }

private:
  vtkShadowShader Shader{ NeighbourShader };
};
vtkStandardNewMacro(NeighbourPass);

}

//------------------------------------------------------------------------------
TEST(Receivers, OfNeighboursAreRightToAFewThousandths)
{
  for (const bool smooth : { false, true })
  {
    // At the edge of a wide view even surfaces that are turned away from its middle are seen.
    for (const double yaw : { 0.0, -60.0, 60.0 })
    {
      const BallScene scene = MakeBallScene();
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetPosition(0.0, -1.2, 1.0);
      camera->SetFocalPoint(0.0, 0.0, 0.8);
      camera->Yaw(yaw);
      camera->SetViewAngle(130.0);
      scene.Renderer->ResetCameraClippingRange();
      vtkNew<NeighbourPass> pass;
      pass->SetSmoothTerminator(smooth);
      Stage stage(scene.Renderer, pass, 240, 180);
      const Picture differences = stage.RenderVisibility(scene.Lamp);
      float largest = 0.0f;
      int pixels = 0;
      for (const float difference : differences.Values)
      {
        if (!std::isnan(difference))
        {
          largest = std::max(largest, difference);
          ++pixels;
        }
      }
      EXPECT_GT(pixels, 10000) << "yaw " << yaw;
      EXPECT_LT(largest, 2.2e-3f) << "yaw " << yaw << ", smooth " << smooth;
      EXPECT_GT(largest, 1e-6f) << "the same texture was read";
    }
  }
}
