package josx.rcxcomm;

/**
 * The numbers of the commands with which a computer that sees through a camera steers a brick.
 *
 * <p>Those that end in I have a number with them, those in V have none.
 */
public interface RemoteVisionConstants {
    /** Drive forward. */
    byte METHOD_JOSX_VISION_RCX_FORWARD_V = 100;

    /** Drive backward. */
    byte METHOD_JOSX_VISION_RCX_BACKWARD_V = 101;

    /** Stop. */
    byte METHOD_JOSX_VISION_RCX_STOP = 102;

    /** Turn left on the spot. */
    byte METHOD_JOSX_VISION_RCX_SPIN_LEFT_V = 103;

    /** Turn right on the spot. */
    byte METHOD_JOSX_VISION_RCX_SPIN_RIGHT_V = 104;

    /** Drive so far forward. */
    byte METHOD_JOSX_VISION_RCX_FORWARD_I = 105;

    /** Drive so far backward. */
    byte METHOD_JOSX_VISION_RCX_BACKWARD_I = 106;

    /** Turn left on the spot by so much. */
    byte METHOD_JOSX_VISION_RCX_SPIN_LEFT_I = 107;

    /** Turn right on the spot by so much. */
    byte METHOD_JOSX_VISION_RCX_SPIN_RIGHT_I = 108;

    /** Drive to the left. */
    byte METHOD_JOSX_VISION_RCX_TURN_LEFT_V = 109;

    /** Drive so far to the left. */
    byte METHOD_JOSX_VISION_RCX_TURN_LEFT_I = 110;

    /** Drive to the right. */
    byte METHOD_JOSX_VISION_RCX_TURN_RIGHT_V = 111;

    /** Drive so far to the right. */
    byte METHOD_JOSX_VISION_RCX_TURN_RIGHT_I = 112;

    /** Turn the camera to the left. */
    byte METHOD_JOSX_VISION_RCX_SCAN_LEFT_V = 113;

    /** Turn the camera to the left by so much. */
    byte METHOD_JOSX_VISION_RCX_SCAN_LEFT_I = 114;

    /** Turn the camera to the right. */
    byte METHOD_JOSX_VISION_RCX_SCAN_RIGHT_V = 115;

    /** Turn the camera to the right by so much. */
    byte METHOD_JOSX_VISION_RCX_SCAN_RIGHT_I = 116;

    /** Set the power of a motor. */
    byte METHOD_JOSX_VISION_RCX_SET_POWER = 117;

    /** Set all motors. */
    byte METHOD_JOSX_VISION_RCX_CONTROL_MOTORS = 118;

    /** Play a tone. */
    byte METHOD_JOSX_VISION_RCX_PLAY_TONE = 119;

    /** Turn the camera up by so much. */
    byte METHOD_JOSX_VISION_RCX_TILT_UP_I = 120;

    /** Turn the camera down by so much. */
    byte METHOD_JOSX_VISION_RCX_TILT_DOWN_I = 121;
}
