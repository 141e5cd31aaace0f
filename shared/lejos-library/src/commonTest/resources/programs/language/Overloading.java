import josx.platform.rcx.LCD;

public class Overloading {
    static int kind(int value) {
        return 1;
    }

    static int kind(float value) {
        return 2;
    }

    static int kind(char value) {
        return 3;
    }

    static int kind(Object value) {
        return 4;
    }

    static int kind(String value) {
        return 5;
    }

    static int kind(int a, int b) {
        return 6;
    }

    public static void main(String[] arguments) {
        LCD.showNumber(kind((byte) 1)); // shows: 1
        LCD.showNumber(kind(1L)); // shows: 2
        LCD.showNumber(kind('1')); // shows: 3
        LCD.showNumber(kind(new int[1])); // shows: 4
        LCD.showNumber(kind("1")); // shows: 5
        LCD.showNumber(kind(1, 1)); // shows: 6
    }
}
