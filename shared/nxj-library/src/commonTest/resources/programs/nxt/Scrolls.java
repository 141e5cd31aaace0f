// screen 0: line 3
// screen 1: line 4
// screen 2: line 5
// screen 3: ABCDEFGHIJKLMNOP
// screen 4: line 7    -42
// screen 5: line 8
// screen 6: line 9
import lejos.nxt.LCD;

/** Everything moves up when the display is full, and other parts of it are written on directly. */
public class Scrolls {
    public static void main(String[] args) throws Exception {
        for (int i = 0; i < 10; i++) System.out.println("line " + i); // prints: line 0 | line 1 | line 2 | line 3 | line 4 | line 5 | line 6 | line 7 | line 8 | line 9
        LCD.drawString("ABCDEFGHIJKLMNOPQR", 0, 3);
        LCD.drawInt(-42, 5, 8, 4); // calls: drawInt -42 5 8 4
        LCD.refresh();
        Thread.sleep(20);
    }
}
