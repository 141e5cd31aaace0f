import lejos.nxt.LCD;
import lejos.util.DebugMessages;
import lejos.util.Delay;

/** Messages fill the rows; the one behind the last row is lost, and the next one is in row 0. */
// screen d
// screen 5
public class MessagesInRows {
    public static void main(String[] arguments) {
        DebugMessages messages = new DebugMessages(6);
        messages.echo("a");
        messages.echo(12);
        messages.setLCDLines(9);
        System.out.println(dots(6) > 0 && dots(7) > 0); // expect true
        messages.echo("lost");
        messages.setLCDLines(1);
        messages.setDelayEnabled(true);
        messages.setDelay(300);
        long begin = System.currentTimeMillis();
        messages.clear();
        messages.echo("c");
        System.out.println((System.currentTimeMillis() - begin) / 100); // expect 6
        messages.clear();
        messages.setDelayEnabled(false);
        messages.echo("d");
        messages.echo(5);
        Delay.msDelay(20);
    }

    static int dots(int row) {
        int count = 0;
        for (int x = 0; x < LCD.SCREEN_WIDTH; x++) {
            for (int y = 8 * row; y < 8 * row + 8; y++) count += LCD.getPixel(x, y);
        }
        return count;
    }
}
