//VTK::System::Dec
//VTK::Output::Dec

// The visibility of the light of this draw, read from an image of the viewport's size.

uniform sampler2D given;
uniform float weight; // of the emitter

void main()
{
  gl_FragData[0] = vec4(weight * texelFetch(given, ivec2(gl_FragCoord.xy), 0).r);
}
