import josx.platform.rcx.LCD;

public class StaticInitialisers {
    static int order = 1;

    static class Lazy {
        static int ready;

        static {
            order = order * 10 + 2;
            ready = 5;
        }

        static void wake() {
        }
    }

    static class Base {
        int value = 1;

        {
            value += 10;
        }

        Base() {
            value += 100;
        }
    }

    static final int[] SQUARES = new int[4];

    static {
        for (int index = 0; index < SQUARES.length; index++) SQUARES[index] = index * index;
    }

    public static void main(String[] arguments) {
        LCD.showNumber(order); // shows: 1
        Lazy.wake();
        LCD.showNumber(order); // shows: 12
        LCD.showNumber(Lazy.ready); // shows: 5
        LCD.showNumber(order); // shows: 12
        LCD.showNumber(new Base().value); // shows: 111
        LCD.showNumber(SQUARES[3]); // shows: 9
    }
}
