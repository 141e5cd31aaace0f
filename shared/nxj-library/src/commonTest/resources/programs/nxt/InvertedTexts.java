import lejos.nxt.LCD;

// A text that is white on black is drawn dot by dot: first its background, then each letter.
public class InvertedTexts {
    public static void main(String[] arguments) {
        LCD.drawString("a", 1, 2, true); // calls bitBlt 100 64 0 0 6 16 6 8 255 | bitBlt 640 8 485 0 6 16 5 8 65535
        LCD.drawString("b", 3, 2, false); // calls drawString "b" 3 2 0
        LCD.drawString("", 4, 2, true); // calls bitBlt 100 64 0 0 24 16 0 8 255
        int black = 0;
        for (int x = 6; x < 12; x++) {
            for (int y = 16; y < 24; y++) black += LCD.getPixel(x, y);
        }
        LCD.drawString("a", 0, 4);
        int drawn = 0;
        for (int x = 0; x < 6; x++) {
            for (int y = 32; y < 40; y++) drawn += LCD.getPixel(x, y);
        }
        System.out.println(black + drawn); // expect 48
        LCD.drawString("\u00e9", 9, 2, true); // calls bitBlt 100 64 0 0 54 16 6 8 255
        try {
            LCD.drawString(null, 0, 0, true);
        } catch (NullPointerException wrong) {
            System.out.println("null"); // expect null
        }
    }
}
