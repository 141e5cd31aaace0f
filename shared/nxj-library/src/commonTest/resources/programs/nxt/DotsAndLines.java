import lejos.nxt.LCD;

/** Single dots, parts of the picture, and the display's own memory. */
public class DotsAndLines {
    public static void main(String[] arguments) {
        LCD.setPixel(5, 9, 1);
        LCD.setPixel(99, 63, 1);
        System.out.println(LCD.getPixel(5, 9) + " " + LCD.getPixel(6, 9) + " " + LCD.getPixel(99, 63)); // expect 1 0 1
        byte[] display = LCD.getDisplay();
        System.out.println(display.length + " " + display[105] + " " + display[799]); // expect 800 2 -128
        LCD.clear();
        System.out.println(LCD.getPixel(99, 63)); // expect 0
        for (int x = 0; x < 20; x++) LCD.setPixel(x, 40, 1);
        int count = 0;
        for (int x = 0; x < LCD.SCREEN_WIDTH; x++) count += LCD.getPixel(x, 40);
        System.out.println(count); // expect 20
        LCD.scroll();
        System.out.println(LCD.getPixel(3, 32) + " " + LCD.getPixel(3, 40)); // expect 1 0
        LCD.bitBlt(display, 100, 64, 0, 32, 50, 48, 20, 1, LCD.ROP_COPY);
        System.out.println(LCD.getPixel(50, 48) + " " + LCD.getPixel(69, 48) + " " + LCD.getPixel(70, 48)); // expect 1 1 0
        LCD.drawChar('I', 0, 0);
        int dots = 0;
        for (int x = 0; x < LCD.CELL_WIDTH; x++) {
            for (int y = 0; y < LCD.CELL_HEIGHT; y++) dots += LCD.getPixel(x, y);
        }
        System.out.println(dots > 5); // expect true
        System.out.println(LCD.DISPLAY_CHAR_WIDTH + " " + LCD.DISPLAY_CHAR_DEPTH); // expect 16 8
    }
}
