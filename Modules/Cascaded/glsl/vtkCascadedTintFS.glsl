//VTK::System::Dec
//VTK::Output::Dec

// A colour per cascade, by which the picture is multiplied: red, green, blue, yellow, near to far.
// The mean over emitters, each of which has cascades of its own.

//SoftShadows::Include vtkShadowReceiver

const int maximumCount = 4;     // of cascades
const int maximumEmitters = 32;

uniform vec4 fades[maximumCount * maximumEmitters]; // depths over which each rises, and falls
uniform int cascadeCounts[maximumEmitters];
uniform int emitterCount;
uniform vec2 origin; // of the viewport in the window

void main()
{
  Receiver receiver;
  if (!loadReceiver(ivec2(gl_FragCoord.xy - origin), receiver))
  {
    discard;
  }
  vec3 tints[maximumCount] = vec3[maximumCount](
    vec3(1.0, 0.55, 0.55), vec3(0.55, 1.0, 0.55), vec3(0.6, 0.65, 1.0), vec3(1.0, 1.0, 0.5));
  float depth = -receiver.positionVs.z;
  vec3 tint = vec3(0.0);
  for (int e = 0; e < emitterCount; ++e)
  {
    for (int i = 0; i < cascadeCounts[e]; ++i)
    {
      vec4 fade = fades[maximumCount * e + i];
      float share = smoothstep(fade.x, fade.y, depth) * (1.0 - smoothstep(fade.z, fade.w, depth));
      tint += share * tints[i];
    }
  }
  gl_FragData[0] = vec4(tint / float(emitterCount), 1.0);
}
