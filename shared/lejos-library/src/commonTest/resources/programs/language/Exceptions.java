import josx.platform.rcx.LCD;

public class Exceptions {
    static class TooHot extends Exception {
        final int degrees;

        TooHot(int degrees) {
            super("too hot");
            this.degrees = degrees;
        }
    }

    static void measure(int degrees) throws TooHot {
        if (degrees > 30) throw new TooHot(degrees);
    }

    public static void main(String[] arguments) {
        try {
            measure(20);
            LCD.showNumber(1); // shows: 1
            measure(35);
            LCD.showNumber(2);
        } catch (TooHot heat) {
            LCD.showNumber(heat.degrees); // shows: 35
            LCD.showNumber(heat.getMessage().length()); // shows: 7
        }
        try {
            measure(40);
        } catch (Exception any) {
            LCD.showNumber(any instanceof TooHot ? 1 : 0); // shows: 1
        }
        try {
            throw new IllegalStateException();
        } catch (IllegalArgumentException wrong) {
            LCD.showNumber(5);
        } catch (RuntimeException right) {
            LCD.showNumber(right.getMessage() == null ? 6 : 7); // shows: 6
        }
    }
}
