package lejos.util;

import lejos.nxt.Button;
import lejos.nxt.LCD;

/** Lets somebody enter two numbers by presses of LEFT and RIGHT; ENTER is the end. */
public class ButtonCounter {
    private int left;
    private int right;

    /** Makes one. */
    public ButtonCounter() {
    }

    /** Counts until ENTER is pressed. */
    public void count() {
        count("");
    }

    /** Counts until ENTER is pressed, and shows a text. */
    public void count(String s) {
        left = 0;
        right = 0;
        int pressed = 0;
        while ((pressed & Button.ID_ENTER) == 0) {
            LCD.clear();
            LCD.drawString(s, 0, 0);
            LCD.drawString("L " + left + " R " + right, 0, 1);
            LCD.refresh();
            pressed = Button.waitForAnyPress();
            if ((pressed & Button.ID_LEFT) != 0) left++;
            if ((pressed & Button.ID_RIGHT) != 0) right++;
        }
    }

    /** Gives how many times LEFT was pressed. */
    public int getLeftCount() {
        return left;
    }

    /** Gives how many times RIGHT was pressed. */
    public int getRightCount() {
        return right;
    }
}
