//VTK::System::Dec
//VTK::Output::Dec

// Steps 3 and 4: a blur along one axis of the screen. Taps count by their place in the kernel and by
// how near their points lie to the receiver's plane.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowKernel

uniform sampler2DArray penumbrae; // half extents of the kernel on the screen; negative: no blocker
uniform sampler2DArray hardShadows;
uniform sampler2DArray blurred;   // along the other axis; negative: not blurred
uniform int hasBlurred;           // 0: this is the first blur
uniform vec2 blurAxis;
uniform vec2 texel;               // of the screen
uniform int filterWidth;
uniform float beta; // standard deviation of the distance to the plane, in shares of the view distance
uniform float weight;

float visibilityAt(vec2 pixel)
{
  float visibility = hasBlurred == 1 ? textureLod(blurred, vec3(pixel, 0.0), 0.0).r : -1.0;
  return visibility < 0.0 ? textureLod(hardShadows, vec3(pixel, 0.0), 0.0).r : visibility;
}

float blur(Receiver receiver, vec2 center, vec2 halfExtent)
{
  float spread = beta * length(receiver.positionVs);
  vec2 total = vec2(0.0);
  for (int i = 0; i < filterWidth; ++i)
  {
    float x = tapCoordinate(i, filterWidth);
    vec2 pixel = center + x * halfExtent;
    if (any(lessThan(pixel, vec2(0.0))) || any(greaterThanEqual(pixel, vec2(1.0))))
    {
      continue;
    }
    vec4 other = receiverAt(pixel);
    float offPlane = dot(other.xyz - receiver.positionVs, receiver.normalVs) / spread;
    float share = exp(-0.5 * offPlane * offPlane) * (kernelGaussian == 1 ? exp(-2.0 * x * x) : 1.0);
    total += other.w == SOFT_SHADOW_RECEIVES ? share * vec2(visibilityAt(pixel), 1.0) : vec2(0.0);
  }
  return total.y > 0.0 ? total.x / total.y : visibilityAt(center);
}

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  vec2 center = gl_FragCoord.xy * texel;
  vec2 extent = textureLod(penumbrae, vec3(center, 0.0), 0.0).xy;
  // Without a blocker there is no penumbra, but a surface that faces away from the light is dark.
  float visibility =
    extent.x < 0.0 ? visibilityAt(center) : blur(receiver, center, extent * blurAxis);
  gl_FragData[0] = vec4(weight * visibility);
}
