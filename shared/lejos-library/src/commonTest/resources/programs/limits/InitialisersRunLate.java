import josx.platform.rcx.LCD;

public class InitialisersRunLate {
    static int order = 0;

    static class Base {
        static {
            order = order * 10 + 1;
        }
    }

    static class Derived extends Base {
        static {
            order = order * 10 + 2;
        }

        static void touch() {
        }
    }

    public static void main(String[] arguments) {
        Derived.touch();
        LCD.showNumber(order); // brick shows: 2 // forgiving shows: 12
        new Derived();
        LCD.showNumber(order); // brick shows: 21 // forgiving shows: 12
    }
}
