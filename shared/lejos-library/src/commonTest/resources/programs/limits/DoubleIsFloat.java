import josx.platform.rcx.LCD;

public class DoubleIsFloat {
    public static void main(String[] arguments) {
        double large = 16777216;
        LCD.showNumber(large + 1 == large ? 1 : 0); // shows: 1
    }
}
