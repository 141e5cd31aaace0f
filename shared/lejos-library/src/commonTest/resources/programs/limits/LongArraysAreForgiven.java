// mode: forgiving
import josx.platform.rcx.LCD;

public class LongArraysAreForgiven {
    public static void main(String[] arguments) {
        LCD.showNumber(new byte[512].length); // shows: 512
    }
}
