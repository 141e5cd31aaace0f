// A stopwatch: ENTER begins anew, ESCAPE ends.
// Next: let LEFT show a split time.

import lejos.nxt.*;
import lejos.util.Delay;

public class Stopwatch {
    public static void main(String[] args) {
        lejos.util.Stopwatch watch = new lejos.util.Stopwatch();
        while (!Button.ESCAPE.isDown()) {
            if (Button.ENTER.isDown()) watch.reset();
            int tenths = watch.elapsed() / 100;
            LCD.drawString(tenths / 10 + "." + tenths % 10 + " s  ", 5, 3);
            Delay.msDelay(50);
        }
    }
}
