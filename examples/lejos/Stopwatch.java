// A stopwatch. View starts and stops it, Prgm sets it back to zero.
// A listener is told when a button is pressed.
// Next: beep every ten seconds.

import josx.platform.rcx.Button;
import josx.platform.rcx.ButtonListener;
import josx.platform.rcx.LCD;
import josx.platform.rcx.LCDConstants;

public class Stopwatch implements ButtonListener {
    private boolean isRunning;
    private int began;
    private int shown; // milliseconds

    public static void main(String[] args) throws InterruptedException {
        Stopwatch watch = new Stopwatch();
        Button.VIEW.addButtonListener(watch);
        Button.PRGM.addButtonListener(watch);
        while (true) {
            watch.show();
            Thread.sleep(100);
        }
    }

    public synchronized void buttonPressed(Button button) {
        if (button == Button.VIEW) {
            isRunning = !isRunning;
            began = now() - shown;
        } else {
            isRunning = false;
            shown = 0;
        }
    }

    public void buttonReleased(Button button) {
        // Only pressing counts.
    }

    synchronized void show() { // not private: a brick would not lock it
        if (isRunning) shown = now() - began;
        LCD.setNumber(LCDConstants.LCD_SIGNED, shown / 100, LCDConstants.LCD_DECIMAL_1);
        LCD.refresh();
    }

    private static int now() {
        return (int) System.currentTimeMillis();
    }
}
