// names.robo, translated by Robotran for leJOS on the RCX.

import josx.platform.rcx.*;

public class Names {
    static int class_ = 1; // in Robolang: class
    static float größe = 2.5f; // centimetres
    static int arguments_ = 3; // in Robolang: arguments

    public static void main(String[] arguments) {
        for (int round = arguments_; round <= 5; round++) {
            main_(round);
        }
        show(class_ + größe);
    }

    static void main_(int int_) { // in Robolang: main, in Robolang: int
        show(int_);
    }

    // The methods below do what the commands of Robolang do.

    /** The nearest whole number, a half upwards. */
    static int roundHalfUp(float value) {
        int below = (int) value;
        return value - below >= 0.5f && below < 2147483647 ? below + 1 : below;
    }

    /** Shows a whole number with its sign. */
    static void show(int number) {
        int digits = Math.max(-32768, Math.min(number, 32767));
        LCD.setNumber(LCDConstants.LCD_SIGNED, digits, LCDConstants.LCD_DECIMAL_0);
        LCD.refresh();
    }

    /** Shows a number with as many digits behind its point as there is room for. */
    static void show(float number) {
        float magnitude = number < 0 ? -number : number;
        int decimals = 3;
        int digits = roundHalfUp(magnitude * 10 * 10 * 10);
        while (digits > 9999 && decimals > 0) {
            decimals--;
            float scaled = magnitude;
            for (int place = 0; place < decimals; place++) scaled *= 10;
            digits = roundHalfUp(scaled);
        }
        while (decimals > 1 && digits % 10 == 0) {
            decimals--;
            digits /= 10;
        }
        digits = Math.min(digits, 32767);
        LCD.setNumber(LCDConstants.LCD_SIGNED, number < 0 ? -digits : digits, LCDConstants.LCD_DECIMAL_0 + decimals);
        LCD.refresh();
    }
}
