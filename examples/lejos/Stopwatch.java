import josx.platform.rcx.Button;
import josx.platform.rcx.ButtonListener;
import josx.platform.rcx.LCD;
import josx.platform.rcx.LCDConstants;

/** Run starts and stops the watch, View sets it to zero. A listener hears of the buttons. */
public class Stopwatch implements ButtonListener {
    private boolean isRunning;
    private int began;
    private int shown;

    public static void main(String[] arguments) throws InterruptedException {
        Stopwatch watch = new Stopwatch();
        Button.RUN.addButtonListener(watch);
        Button.VIEW.addButtonListener(watch);
        while (true) {
            watch.show();
            Thread.sleep(100);
        }
    }

    public synchronized void buttonPressed(Button button) {
        if (button == Button.VIEW) {
            shown = 0;
            began = now();
        } else {
            isRunning = !isRunning;
            began = now() - shown;
        }
    }

    public void buttonReleased(Button button) {
    }

    private synchronized void show() {
        if (isRunning) shown = now() - began;
        LCD.setNumber(LCDConstants.LCD_SIGNED, shown / 100, LCDConstants.LCD_DECIMAL_1);
        LCD.refresh();
    }

    private static int now() {
        return (int) System.currentTimeMillis();
    }
}
