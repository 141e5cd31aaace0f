import josx.platform.rcx.LCD;
import josx.platform.rcx.SensorListener;

public class InstanceofInterface {
    public static void main(String[] arguments) {
        Object text = "text";
        LCD.showNumber(text instanceof SensorListener ? 1 : 0); // brick shows: 1 // forgiving shows: 0
    }
}
