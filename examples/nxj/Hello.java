// Greets you on the display and waits for ENTER.
// Next: show your own name in the middle of the display.

import lejos.nxt.*;

public class Hello {
    public static void main(String[] args) {
        LCD.drawString("Hello, I am", 0, 0);
        LCD.drawString("an NXT.", 0, 1);
        System.out.println("Press ENTER.");
        Button.ENTER.waitForPressAndRelease();
        LCD.clear();
        LCD.drawString("Bye!", 6, 3);
        Sound.beepSequence();
        Button.waitForAnyPress(2000);
    }
}
