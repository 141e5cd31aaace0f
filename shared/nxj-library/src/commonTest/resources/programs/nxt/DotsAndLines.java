import lejos.nxt.LCD;

/** Single dots, parts of the picture, and the display's own memory. */
public class DotsAndLines {
    public static void main(String[] arguments) {
        StringBuilder log = new StringBuilder();
        LCD.setPixel(5, 9, 1);
        LCD.setPixel(99, 63, 1);
        log.append(LCD.getPixel(5, 9)).append(LCD.getPixel(6, 9)).append(LCD.getPixel(99, 63)).append(' ');
        byte[] display = LCD.getDisplay();
        log.append(display.length).append(' ').append(display[105]).append(' ').append(display[799]).append('\n');
        LCD.clear();
        log.append(LCD.getPixel(99, 63)).append(' ');
        for (int x = 0; x < 20; x++) LCD.setPixel(x, 40, 1);
        int count = 0;
        for (int x = 0; x < LCD.SCREEN_WIDTH; x++) count += LCD.getPixel(x, 40);
        log.append(count).append(' ');
        LCD.scroll();
        log.append(LCD.getPixel(0, 32)).append(LCD.getPixel(3, 40)).append('\n');
        LCD.bitBlt(display, 100, 64, 0, 32, 50, 48, 20, 1, LCD.ROP_COPY);
        log.append(LCD.getPixel(50, 48)).append(LCD.getPixel(69, 48)).append(LCD.getPixel(70, 48)).append(' ');
        LCD.bitBlt(display, 100, 64, 0, 32, 0, 32, 20, 1, LCD.ROP_XOR);
        log.append(LCD.getPixel(0, 32)).append(' ');
        LCD.drawChar('I', 0, 0);
        int dots = 0;
        for (int x = 0; x < LCD.CELL_WIDTH; x++) {
            for (int y = 0; y < LCD.CELL_HEIGHT; y++) dots += LCD.getPixel(x, y);
        }
        log.append(dots > 5);
        System.out.println(log);
        // expect 101 800 2 -128
        // expect 0 20 10
        // expect 110 0 true
        System.out.println(LCD.DISPLAY_CHAR_WIDTH + " " + LCD.DISPLAY_CHAR_DEPTH); // expect 16 8
    }
}
