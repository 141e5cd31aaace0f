// mode: forgiving
import josx.platform.rcx.LCD;

public class LargeDivisorsAreForgiven {
    public static void main(String[] arguments) {
        int divisor = 70000;
        LCD.showNumber(200000 / divisor); // shows: 2
        divisor = 65536;
        LCD.showNumber(200000 / divisor); // shows: 3
    }
}
