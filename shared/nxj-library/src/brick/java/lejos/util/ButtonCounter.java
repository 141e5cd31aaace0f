package lejos.util;

import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.Sound;

/**
 * Lets somebody enter two numbers: LEFT and RIGHT count up, together with ENTER they count down, and ESCAPE is the end.
 *
 * <p>A button that is held counts on, with a beep each time. The display shows both numbers in row 1.
 */
public class ButtonCounter {
    private static final String BLANK = "                ";
    private static final int PLACES = 4;
    private static final int RIGHT_COLUMN = 8;

    /** Milliseconds until it is sure which buttons are pressed together. */
    private static final int TOGETHER = 200;

    /** Milliseconds from one count to the next while a button is held. */
    private static final int REPEAT = 400;

    private static final int PERIOD = 10;

    /** How many times RIGHT has counted. */
    public int _rightCount;

    /** How many times LEFT has counted. */
    public int _leftCount;

    private boolean keepsCounts;

    /** Makes one. */
    public ButtonCounter() {
    }

    /** Shows a text in row 0, and counts from 0 until ESCAPE is pressed. */
    public void count(String s) {
        showText(s);
        keepsCounts = false;
        count();
    }

    /** Shows a text in row 0, and counts from these numbers until ESCAPE is pressed. */
    public void count(String s, int left, int right) {
        showText(s);
        keepsCounts = true;
        _leftCount = left;
        _rightCount = right;
        count();
    }

    /** Counts until ESCAPE is pressed. */
    public void count() {
        if (!keepsCounts) {
            _leftCount = 0;
            _rightCount = 0;
        }
        while (Button.readButtons() != 0) Delay.msDelay(PERIOD);
        show();
        while (true) {
            int pressed = Button.waitForAnyPress();
            Delay.msDelay(TOGETHER);
            int held = Button.readButtons();
            if ((pressed | held) == Button.ID_ESCAPE) return;
            count(pressed | held, held);
        }
    }

    /** Gives how many times LEFT has counted. */
    public int getLeftCount() {
        return _leftCount;
    }

    /** Gives how many times RIGHT has counted. */
    public int getRightCount() {
        return _rightCount;
    }

    /** Counts once, and again and again as long as the buttons are held. */
    private void count(int buttons, int held) {
        int step = (buttons & Button.ID_ENTER) == 0 ? 1 : -1;
        int counted = buttons & ~Button.ID_ENTER;
        Stopwatch watch = new Stopwatch();
        boolean isHeld = held == buttons;
        do {
            if (counted == Button.ID_LEFT) _leftCount += step;
            if (counted == Button.ID_RIGHT) _rightCount += step;
            show();
            if (counted != Button.ID_LEFT && counted != Button.ID_RIGHT) return;
            while (isHeld && watch.elapsed() < REPEAT) {
                Delay.msDelay(PERIOD);
                isHeld = Button.readButtons() == buttons;
            }
            watch.reset();
            if (isHeld) Sound.beep();
        } while (isHeld);
    }

    private static void showText(String text) {
        LCD.drawString(BLANK, 0, 0);
        LCD.drawString(text, 0, 0);
    }

    private void show() {
        LCD.drawString(BLANK, 0, 1);
        LCD.drawInt(_leftCount, PLACES, 0, 1);
        LCD.drawInt(_rightCount, PLACES, RIGHT_COLUMN, 1);
    }
}
