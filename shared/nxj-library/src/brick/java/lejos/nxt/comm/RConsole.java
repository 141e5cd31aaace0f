package lejos.nxt.comm;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;

/** Writes texts into the log of the run, as if a computer were connected; it never waits. */
public class RConsole {
    private static boolean isOpen;

    private RConsole() {
    }

    /** Opens the console. */
    public static void open() {
        isOpen = true;
    }

    /** Opens the console; the time does not matter. */
    public static void openUSB(int timeout) {
        open();
    }

    /** Opens the console; the time does not matter. */
    public static void openBluetooth(int timeout) {
        open();
    }

    /** Opens the console; the time does not matter. */
    public static void openAny(int timeout) {
        open();
    }

    /** Says whether the console is open. */
    public static boolean isOpen() {
        return isOpen;
    }

    /** Writes a text. */
    public static void print(String s) {
        if (isOpen) log(s);
    }

    /** Writes a text, and begins a new line. */
    public static void println(String s) {
        print(s + "\n");
    }

    /**
     * Begins a new line.
     *
     * @hidden
     */
    public static void println() {
        print("\n");
    }

    /** Gives a stream that writes onto the console. */
    public static PrintStream getPrintStream() {
        return openPrintStream();
    }

    /**
     * Gives a stream that writes onto the console.
     *
     * @hidden
     */
    public static PrintStream openPrintStream() {
        return new PrintStream(new Stream());
    }

    /**
     * Gives a stream that writes bytes onto the console.
     *
     * @hidden
     */
    public static OutputStream openOutputStream() {
        return new Stream();
    }

    /** Closes the console. */
    public static void close() {
        isOpen = false;
    }

    private static native void log(String text);

    private static class Stream extends OutputStream {
        private final StringBuilder line = new StringBuilder();

        Stream() {
        }

        public synchronized void write(int value) throws IOException {
            line.append((char) (value & 0xFF));
            if (value == '\n') flush();
        }

        public synchronized void flush() throws IOException {
            print(line.toString());
            line.setLength(0);
        }
    }
}
