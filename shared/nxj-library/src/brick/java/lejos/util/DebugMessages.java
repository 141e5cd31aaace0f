package lejos.util;

import lejos.nxt.LCD;

/** Writes messages on the display, each in the next row, and begins anew when the rows are full. */
public class DebugMessages {
    private static final int MOST = 7;

    private int row;
    private int lastRow = MOST;
    private int delay = 250;
    private boolean waits;

    /** Makes one that begins in row 0. */
    public DebugMessages() {
    }

    /** Makes one that begins in a row. */
    public DebugMessages(int init) {
        row = init;
    }

    /** Sets the last row, at most 7. */
    public void setLCDLines(int lines) {
        if (lines <= MOST) lastRow = lines;
    }

    /** Says whether it waits after each message. */
    public void setDelayEnabled(boolean de) {
        waits = de;
    }

    /** Sets how many milliseconds it waits if it does; 250 to begin with. */
    public void setDelay(int dMs) {
        delay = dMs;
    }

    /** Writes a text in the next row; when all are full, the display is cleared and the text is lost, as in leJOS NXJ. */
    public void echo(String message) {
        if (hasRow()) {
            LCD.drawString(message, 0, row);
            LCD.refresh();
            row++;
        }
        pause();
    }

    /** Writes a number in the next row; when all are full, it is lost and the display is cleared, as in leJOS NXJ. */
    public void echo(int message) {
        if (hasRow()) {
            LCD.drawInt(message, 0, row);
            LCD.refresh();
            row++;
        }
        pause();
    }

    /** Clears the display; the next message is in row 0. */
    public void clear() {
        begin();
        pause();
    }

    private boolean hasRow() {
        if (row <= lastRow) return true;
        begin();
        return false;
    }

    private void begin() {
        LCD.clear();
        row = 0;
    }

    private void pause() {
        if (!waits) return;
        try {
            Thread.sleep(delay);
        } catch (InterruptedException goOn) {
            // An interrupt only ends the pause.
        }
    }
}
