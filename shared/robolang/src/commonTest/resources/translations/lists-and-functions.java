// lists-and-functions.robo, translated by Robotran for leJOS on the RCX.

import josx.platform.rcx.*;
import java.util.*;

public class ListsAndFunctions {
    /** The brick's clock decides which numbers it throws. */
    static final Random dice = new Random();

    static final int[] notes = {262, 294, 330};
    static int loudest = 0;

    public static void main(String[] arguments) throws InterruptedException {
        for (int i = 0; i < notes.length; i++) {
            play(notes[i], 0.5f);
            loudest = Math.max(loudest, notes[i]);
        }
        for (float angle = 0; angle <= 90; angle += 0.5f) {
            show(sin(angle) * sqrt(2));
        }
        if (higher(notes, random(200, 400))) {
            show(area(3, 4 + loudest) % 7);
        }
        show(remainder(7.5f, 2));
    }

    static int area(int width, int height) {
        return width * height;
    }

    static boolean higher(int[] list, int limit) {
        for (int position = 0; position < list.length; position++) {
            int note = list[position];
            if (note > limit) {
                return true;
            }
        }
        return false;
    }

    // The methods below do what the commands of Robolang do.

    /** The nearest whole number, a half upwards. */
    static int roundHalfUp(float value) {
        int below = (int) value;
        return value - below >= 0.5f && below < 2147483647 ? below + 1 : below;
    }

    /** Plays a tone to its end; a long one is several, for the brick plays 2.55 seconds at most. */
    static void play(int frequency, float seconds) throws InterruptedException {
        int hundredths = roundHalfUp(seconds * 100);
        while (hundredths > 0) {
            int part = Math.min(hundredths, 255);
            Sound.playTone(frequency, part);
            Thread.sleep(part * 10);
            hundredths -= part;
        }
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

    /** What is left of a division without a fraction: the brick has no % for decimal numbers. */
    static float remainder(float left, float right) {
        return left - right * (int) (left / right);
    }

    /** A whole number from one to another, both included. */
    static int random(int first, int last) {
        int smaller = Math.min(first, last);
        int count = Math.max(first, last) - smaller + 1;
        if (count <= 0) return dice.nextInt();
        int rest = dice.nextInt() % count;
        return smaller + (rest < 0 ? rest + count : rest);
    }

    /** The whole number below. */
    static int floor(float value) {
        int truncated = (int) value;
        return truncated > value ? truncated - 1 : truncated;
    }

    /** The nearest whole number, a half upwards. */
    static int round(float value) {
        int below = floor(value);
        return value - below >= 0.5f && below < 2147483647 ? below + 1 : below;
    }

    /** The square root. */
    static float sqrt(float value) {
        return (float) Math.sqrt(value);
    }

    /** Sine of an angle up to an eighth of a turn, in radians. */
    static float sineOfSmall(float x) {
        float square = x * x;
        return x * (1f - square / 6f * (1f - square / 20f * (1f - square / 42f * (1f - square / 72f))));
    }

    /** Cosine of an angle up to an eighth of a turn, in radians. */
    static float cosineOfSmall(float x) {
        float square = x * x;
        return 1f - square / 2f * (1f - square / 12f * (1f - square / 30f * (1f - square / 56f)));
    }

    /** Sine of an angle in degrees. */
    static float sin(float degrees) {
        if (!(degrees > -16777216f && degrees < 16777216f)) return 0f;
        int quarters = round(degrees / 90f);
        float rest = (degrees - quarters * 90f) * 0.017453292f;
        int quarter = quarters & 3;
        if (quarter == 0) return sineOfSmall(rest);
        if (quarter == 1) return cosineOfSmall(rest);
        if (quarter == 2) return -sineOfSmall(rest);
        return -cosineOfSmall(rest);
    }
}
