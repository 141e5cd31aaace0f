package josx.platform.rcx;

/** Shows short texts on the display, as well as seven strokes can. */
public class TextLCD {
    private static final int CHARACTERS = 5;
    private static final int STROKES = 7;
    private static final int FIRST_ADDRESS = 0xEF43;

    /** The strokes of the characters from 0 to 127: bit 0 middle, then top right, top, top left, bottom left, bottom, bottom right. */
    private static final byte[] SHAPES = {
        0x00, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20,
        0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20, 0x20,
        0x00, 0x42, 0x0A, 0x7B, 0x6D, 0x13, 0x7D, 0x08, 0x3C, 0x66, 0x5B, 0x43, 0x10, 0x01, 0x10, 0x13,
        0x7E, 0x42, 0x37, 0x67, 0x4B, 0x6D, 0x7D, 0x46, 0x7F, 0x6F, 0x21, 0x21, 0x31, 0x21, 0x61, 0x17,
        0x3F, 0x5F, 0x79, 0x3C, 0x73, 0x3D, 0x1D, 0x7C, 0x5B, 0x42, 0x62, 0x5B, 0x38, 0x5E, 0x5E, 0x7E,
        0x1F, 0x4F, 0x11, 0x6D, 0x46, 0x7A, 0x7A, 0x7A, 0x5B, 0x6B, 0x37, 0x3C, 0x49, 0x66, 0x0E, 0x20,
        0x02, 0x5F, 0x79, 0x31, 0x73, 0x3D, 0x1D, 0x7C, 0x59, 0x42, 0x62, 0x5B, 0x38, 0x51, 0x51, 0x71,
        0x1F, 0x4F, 0x11, 0x6D, 0x39, 0x70, 0x70, 0x70, 0x5B, 0x6B, 0x37, 0x3C, 0x18, 0x66, 0x0E, 0x00,
    };

    /** Where the strokes of each place are, the rightmost place first: eight times the bytes behind the first address, plus the bit. */
    private static final byte[] PLACES = {
        13, 21, 12, 37, 39, 15, 23,
        5, 33, 4, 45, 47, 7, 35,
        9, 41, 8, 53, 55, 11, 43,
        25, 65, 24, 69, 71, 27, 67,
        29, 57, 28, 61, 63, 31, 59,
    };

    private TextLCD() {
    }

    /** Shows the first five characters of a text at once. */
    public static void print(String text) {
        int length = text.length();
        for (int place = 0; place < CHARACTERS; place++) {
            printChar(place < length ? text.charAt(place) : ' ', CHARACTERS - 1 - place);
        }
        LCD.refresh();
    }

    /** Shows the first five characters of an array at once. */
    public static void print(char[] text) {
        for (int place = 0; place < CHARACTERS; place++) {
            printChar(place < text.length ? text[place] : ' ', CHARACTERS - 1 - place);
        }
        LCD.refresh();
    }

    /** Writes one character at a place, 0 on the right to 4 on the left; LCD.refresh shows it. */
    public static void printChar(char character, int place) {
        int shape = SHAPES[character];
        int first = place * STROKES;
        for (int stroke = 0; stroke < STROKES; stroke++) {
            int where = PLACES[first + stroke];
            Memory.setBit(FIRST_ADDRESS + (where >> 3), where & 7, shape & 1);
            shape >>= 1;
        }
    }
}
