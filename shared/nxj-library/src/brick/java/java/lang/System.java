package java.lang;

import java.io.PrintStream;
import lejos.nxt.LCDOutputStream;

/** The brick as a whole: its display for texts, its clock and its end. */
public final class System {
    /** Writes onto the display, line by line; it moves up when it is full. */
    public static PrintStream out = new PrintStream(new LCDOutputStream());

    /** Writes mistakes onto the display, with lines of its own. */
    public static PrintStream err = new PrintStream(new LCDOutputStream());

    private System() {
    }

    /** Ends the program: the motors roll out, and the brick's menu comes back. */
    public static void exit(int code) {
        Shutdown.exit(code);
    }

    /** Gives the milliseconds since the brick was switched on. */
    public static native long currentTimeMillis();

    /** Gives the nanoseconds since the brick was switched on. */
    public static native long nanoTime();

    /** Copies elements from one array into another, or within one. */
    public static native void arraycopy(Object source, int from, Object target, int to, int count);

    /** Frees the memory of objects that nobody needs any more; the brick does it by itself, too. */
    public static native void gc();

    /** Gives the number that hashCode of Object gives. */
    public static int identityHashCode(Object object) {
        return object == null ? 0 : getDataAddress(object);
    }

    /** Gives null: a brick has no properties. */
    public static String getProperty(String key) {
        return null;
    }

    /** Gives the other text: a brick has no properties. */
    public static String getProperty(String key, String otherwise) {
        String text = getProperty(key);
        return text == null ? otherwise : text;
    }

    /** Gives what knows how full the memory is; better take that of Runtime. */
    public static Runtime getRuntime() {
        return Runtime.getRuntime();
    }

    /** Sets where out writes. */
    public static void setOut(PrintStream stream) {
        out = stream;
    }

    /** Sets where err writes. */
    public static void setErr(PrintStream stream) {
        err = stream;
    }

    static native int getDataAddress(Object object);
}
