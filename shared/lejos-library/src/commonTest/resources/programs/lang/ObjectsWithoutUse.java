import josx.platform.rcx.Battery;
import josx.platform.rcx.LCD;
import josx.platform.rcx.Memory;
import josx.platform.rcx.MinuteTimer;
import josx.platform.rcx.ROM;
import josx.util.Assertion;

public class ObjectsWithoutUse {
    /** leJOS does not forbid to extend them. */
    static class MyBattery extends Battery {
        static boolean isWeak() {
            return getVoltage() < 5f;
        }
    }

    public static void main(String[] arguments) {
        Object[] objects = {new Battery(), new Class(), new Memory(), new MinuteTimer(), new ROM(), new Assertion(), new MyBattery()};
        LCD.showNumber(objects.length); // shows: 7
        LCD.showNumber(MyBattery.isWeak() ? 1 : 0); // shows: 0
    }
}
