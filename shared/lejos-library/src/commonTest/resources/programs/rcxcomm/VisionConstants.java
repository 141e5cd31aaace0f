import josx.platform.rcx.LCD;
import josx.rcxcomm.RemoteVisionConstants;

public class VisionConstants implements RemoteVisionConstants {
    public static void main(String[] arguments) {
        byte command = METHOD_JOSX_VISION_RCX_FORWARD_V;
        LCD.showNumber(command); // shows: 100
        LCD.showNumber(METHOD_JOSX_VISION_RCX_STOP); // shows: 102
        LCD.showNumber(RemoteVisionConstants.METHOD_JOSX_VISION_RCX_PLAY_TONE); // shows: 119
        LCD.showNumber(METHOD_JOSX_VISION_RCX_TILT_DOWN_I); // shows: 121
    }
}
