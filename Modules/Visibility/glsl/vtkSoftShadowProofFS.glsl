//VTK::System::Dec
//VTK::Output::Dec

// Marks the pixels of an emitter. Depth 1: a technique has to filter the pixel. Depth 0 and a
// visibility: proved. Discarded: the emitter does not serve the pixel, which keeps its -1. The
// colour is added to -1.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowProof

uniform int proof;      // vtkSoftShadowPass::ProofType
uniform int hasCasters; // 0: nothing blocks this emitter
uniform mat4 viewToMap;
uniform vec2 kernelScale;
uniform float mapLayer;

void main()
{
  Receiver receiver;
  if (!loadReceiver(ivec2(gl_FragCoord.xy), receiver) || !lightReaches(receiver.positionVs))
  {
    discard;
  }
  float visibility = -1.0;
  if (hasCasters == 0)
  {
    visibility = 1.0;
  }
  else if (proof > 0)
  {
    MapPoint point = toMap(viewToMap, receiver);
    visibility = proveVisibility(point, kernelScale, mapLayer);
    // The technique's own maps tell; this one may hold the least depths within its texels.
    if (visibility > 0.0 && isInCrease(point, kernelScale, creaseReach, mapLayer))
    {
      visibility = -1.0;
    }
    if (visibility == 0.0 && proof == 1 && point.facesCenter)
    {
      visibility = -1.0;
    }
  }
  gl_FragDepth = visibility < 0.0 ? 1.0 : 0.0;
  gl_FragData[0] = vec4(1.0 + max(visibility, 0.0));
}
