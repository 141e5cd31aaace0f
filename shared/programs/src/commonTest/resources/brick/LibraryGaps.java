import java.util.Stack;
import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

/** What the class library has for computers' habits, and a brick has not. */
public class LibraryGaps implements SensorConstants {
    static void leave(java.net.Socket socket) throws java.io.IOException {
        socket.close(); // error: Leave it out
    }

    public static void main(String[] args) {
        StringBuilder text = null; // error: StringBuffer
        Stack pile = new Stack(); // error 2.1: Vector
        int depth = pile.search("a"); // error: stack.size() - stack.lastIndexOf(object)
        char[] whole = StringUtils.getCharacters(7); // error: Integer.toString(number)
        char[] decimal = StringUtils.getCharacters(7.5f); // error: new StringBuffer(20).append(number)
        Sensor.S1.setTypeAndMode(Sensor.SENSOR_TYPE_TOUCH, 0x20); // error: SensorConstants.SENSOR_TYPE_TOUCH
        Sensor.S2.setTypeAndMode(SENSOR_TYPE_LIGHT, SensorConstants.SENSOR_MODE_PCT);
        LCD.showNumber(depth + whole.length + decimal.length);
    }
}
