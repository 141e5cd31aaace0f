package lejos.internal;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.Vector;
import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.MotorPort;
import lejos.nxt.VM;
import lejos.util.Delay;

/** Shows an exception that nobody has caught, until somebody presses ESCAPE. */
public final class ExceptionScreen {
    private ExceptionScreen() {
    }

    /** Stops everything, shows the exception, and ends the program. */
    public static void show(Throwable thrown) {
        VM.suspendThread(null);
        for (int port = 0; port < MotorPort.NUMBER_OF_PORTS; port++) {
            MotorPort.getInstance(port).controlMotor(0, MotorPort.FLOAT);
        }
        LCD.setAutoRefresh(false);
        Lines lines = new Lines();
        thrown.printStackTrace(new PrintStream(lines));
        int left = 0;
        int pressed;
        do {
            draw(lines.all, left);
            pressed = awaitPress();
            if ((pressed & Button.ID_LEFT) != 0 && left > 0) left--;
            if ((pressed & Button.ID_RIGHT) != 0) left++;
        } while ((pressed & Button.ID_ESCAPE) == 0);
        // A thread may hold a monitor that is needed at the end.
        VM.resumeThread(null);
        System.exit(1);
    }

    private static void draw(Vector<String> lines, int left) {
        LCD.clear();
        for (int row = 0; row < lines.size() && row < LCD.DISPLAY_CHAR_DEPTH; row++) {
            String line = lines.elementAt(row);
            if (left < line.length()) LCD.drawString(line.substring(left), 0, row);
        }
        LCD.refresh();
    }

    /** Waits without help of other threads, because all of them stand still. */
    private static int awaitPress() {
        while (getButtons() != 0) Delay.msDelay(10);
        int pressed = 0;
        while (pressed == 0) {
            Delay.msDelay(10);
            pressed = getButtons();
        }
        return pressed;
    }

    // That of Button, whose own methods may have to wait for a thread that stands still.
    private static native int getButtons();

    /** Takes texts apart into lines. */
    private static class Lines extends OutputStream {
        final Vector<String> all = new Vector<String>();
        private final StringBuilder line = new StringBuilder();

        Lines() {
        }

        public void write(int value) throws IOException {
            if (value == '\n') {
                all.addElement(line.toString());
                line.setLength(0);
            } else {
                line.append((char) value);
            }
        }
    }
}
