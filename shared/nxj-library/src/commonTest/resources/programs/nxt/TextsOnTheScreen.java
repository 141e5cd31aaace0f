import lejos.nxt.LCD;

// screen Hello      7
// screen ABCDEFGHIJKLMNOP
// screen      -42
// screen           123456
// screen left  right
// screen
// screen in two
// screen rows
public class TextsOnTheScreen {
    public static void main(String[] arguments) throws InterruptedException {
        LCD.drawString("Hello", 0, 0);
        LCD.drawInt(7, 2, 10, 0); // calls drawInt 7 2 10 0
        LCD.drawString("ABCDEFGHIJKLMNOPQRSTUV", 0, 1);
        LCD.drawInt(-42, 5, 2);
        LCD.drawString("wiped", 0, 3);
        LCD.clear(3);
        LCD.drawInt(123456, 10, 3);
        LCD.drawString("left", 0, 4);
        LCD.drawString("middle right", 4, 4);
        LCD.clear(4, 4, 12);
        LCD.drawString(" right", 5, 4);
        LCD.drawString("beyond", 0, 8);
        LCD.drawString("in two\nrows", 0, 6);
        try {
            LCD.drawString(null, 0, 0);
        } catch (NullPointerException wrong) {
            LCD.refresh();
        }
        Thread.sleep(300);
    }
}
