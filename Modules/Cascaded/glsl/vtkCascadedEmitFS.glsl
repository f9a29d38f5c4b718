//VTK::System::Dec
//VTK::Output::Dec

// A cascade's part of the refined visibility.

//SoftShadows::Include vtkShadowReceiver

uniform sampler2DArray state;
uniform vec2 fadeIn;
uniform vec2 fadeOut;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Receiver receiver;
  loadReceiver(pixel, receiver);
  float depth = -receiver.positionVs.z;
  float share = smoothstep(fadeIn.x, fadeIn.y, depth) * (1.0 - smoothstep(fadeOut.x, fadeOut.y, depth));
  gl_FragData[0] = vec4(share * texelFetch(state, ivec3(pixel, 0), 0).r);
}
