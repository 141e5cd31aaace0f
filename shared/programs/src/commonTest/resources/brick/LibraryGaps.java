import java.util.Stack;
import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

/** What the class library has for computers' habits, and a brick has not. */
public class LibraryGaps implements SensorConstants {
    static void leave(java.net.Socket socket) throws java.io.IOException {
        socket.close(); // brick error: Leave it out
    }

    public static void main(String[] args) {
        StringBuilder text = null; // brick error: StringBuffer
        Stack pile = new Stack(); // brick lejos 2.1 error: Vector
        int depth = pile.search("a"); // brick error: stack.size() - stack.lastIndexOf(object)
        char[] whole = StringUtils.getCharacters(7); // brick error: Integer.toString(number)
        char[] decimal = StringUtils.getCharacters(7.5f); // brick error: new StringBuffer(20).append(number)
        Sensor.S1.setTypeAndMode(Sensor.SENSOR_TYPE_TOUCH, 0x20); // brick error: SensorConstants.SENSOR_TYPE_TOUCH
        Sensor.S2.setTypeAndMode(SENSOR_TYPE_LIGHT, SensorConstants.SENSOR_MODE_PCT);
        LCD.showNumber(depth + whole.length + decimal.length);
    }
}
