package josx.util;

/** Checks that something is as it should be, and ends the thread with an Error if not. */
public class Assertion {
    /** Makes an object, of which nobody has a use: call the methods on the class. */
    public Assertion() {
    }

    /** Fails with the message unless it is true. */
    public static void test(String message, boolean isTrue) {
        if (!isTrue) throw new Error(message);
    }

    /** Fails with the message unless both numbers are the same. */
    public static void testEQ(String message, int expected, int actual) {
        if (expected != actual) throw new Error(message);
    }
}
