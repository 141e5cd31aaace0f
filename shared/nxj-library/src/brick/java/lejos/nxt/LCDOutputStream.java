package lejos.nxt;

import java.io.IOException;
import java.io.OutputStream;

/** Writes characters onto the display, row by row; everything moves up when it is full. */
public class LCDOutputStream extends OutputStream {
    private static final int TAB = 8;
    private static final int LONGEST_LINE = 256;

    private int x;
    private int y;

    /** What has been written of a line, for the log. */
    private byte[] line = new byte[LCD.DISPLAY_CHAR_WIDTH];
    private int length;

    /** Makes one that begins in the upper left corner. */
    public LCDOutputStream() {
    }

    /** Writes a character, or goes to the next row for the end of a line. */
    public void write(int value) throws IOException {
        char character = (char) (value & 0xFF);
        if (character == '\n') {
            consoleLine(line, length);
            length = 0;
            nextRow();
            return;
        }
        log((byte) value);
        if (character == '\r') {
            x = 0;
        } else if (character == '\t') {
            x = x / TAB * TAB + TAB;
        } else {
            if (x >= LCD.DISPLAY_CHAR_WIDTH) nextRow();
            LCD.drawChar(character, x, y);
            x++;
        }
    }

    private void log(byte character) {
        if (length == line.length) {
            if (length == LONGEST_LINE) return;
            byte[] longer = new byte[2 * length];
            System.arraycopy(line, 0, longer, 0, length);
            line = longer;
        }
        line[length++] = character;
    }

    private void nextRow() {
        x = 0;
        if (y < LCD.DISPLAY_CHAR_DEPTH - 1) {
            y++;
        } else {
            LCD.scroll();
        }
    }

    private static native void consoleLine(byte[] line, int length);
}
