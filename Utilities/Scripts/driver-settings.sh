# Sourced by check-drivers.sh and check-shaders.sh: OpenGL drivers by name, as environments for one command.

# What a driver of OpenGL 3.2 and no more lacks of all that VTK or this library ask for.
gl32_missing="-GL_ARB_texture_gather -GL_ARB_base_instance -GL_ARB_draw_indirect -GL_ARB_multi_draw_indirect"
gl32_missing+=" -GL_ARB_clip_control -GL_ARB_gpu_shader5 -GL_ARB_shader_viewport_layer_array"
gl32_missing+=" -GL_AMD_vertex_shader_layer -GL_NV_conservative_raster -GL_ARB_texture_barrier"
gl32_missing+=" -GL_ARB_texture_storage -GL_ARB_buffer_storage -GL_ARB_copy_image -GL_ARB_shader_image_load_store"

# What the driver calls itself in the report of softshadow render, as a pattern.
driver_pattern() {
    case "$1" in
        llvmpipe-256) echo 'llvmpipe.* 256 bits' ;;
        llvmpipe-128) echo 'llvmpipe.* 128 bits' ;;
        softpipe) echo 'softpipe' ;;
        gl32) echo 'llvmpipe.*OpenGL 3\.2' ;;
        softpipe-gl32) echo 'softpipe.*OpenGL 3\.2' ;;
        zink) echo 'zink' ;;
    esac
}

# Runs a command under a driver: with_driver <name> <command> [argument...]
with_driver() {
    local name="$1"
    shift
    local -a settings=(GALLIUM_DRIVER=llvmpipe LP_NATIVE_VECTOR_WIDTH=256)
    case "$name" in
        llvmpipe-256 | gl32) ;;
        llvmpipe-128) settings=(GALLIUM_DRIVER=llvmpipe LP_NATIVE_VECTOR_WIDTH=128) ;;
        softpipe | softpipe-gl32) settings=(GALLIUM_DRIVER=softpipe) ;;
        # On a screen it needs DRI3; without one VTK draws through EGL, from 9.4 on.
        zink) settings=(-u DISPLAY MESA_LOADER_DRIVER_OVERRIDE=zink GALLIUM_DRIVER=zink) ;;
        *)
            echo "no such driver: $name" >&2
            return 2
            ;;
    esac
    case "$name" in
        *gl32)
            settings+=(MESA_GL_VERSION_OVERRIDE=3.2 MESA_GLSL_VERSION_OVERRIDE=150
                "MESA_EXTENSION_OVERRIDE=$gl32_missing")
            ;;
    esac
    env "${settings[@]}" LIBGL_ALWAYS_SOFTWARE=1 "$@"
}
