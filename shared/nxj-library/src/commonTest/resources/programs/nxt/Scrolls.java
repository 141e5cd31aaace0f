import lejos.nxt.LCD;

/** Everything moves up when the display is full, and other parts of it are written on directly. */
public class Scrolls {
    public static void main(String[] args) throws Exception {
        for (int i = 0; i < 10; i++) System.out.println("line " + i);
        // screen line 3
        // screen line 4
        // screen line 5
        LCD.drawString("ABCDEFGHIJKLMNOPQR", 0, 3); // screen ABCDEFGHIJKLMNOP
        LCD.drawInt(-42, 5, 8, 4); // screen line 7    -42
        // screen line 8
        // screen line 9
        LCD.refresh();
        Thread.sleep(20);
    }
}
// expect line 0
// expect line 1
// expect line 2
// expect line 3
// expect line 4
// expect line 5
// expect line 6
// expect line 7
// expect line 8
// expect line 9
