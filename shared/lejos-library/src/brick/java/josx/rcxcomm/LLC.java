package josx.rcxcomm;

import josx.platform.rcx.Serial;

/**
 * Sends and receives plain bytes of infrared light, without LEGO's messages around them.
 *
 * <p>From init on the brick hears nothing else: leave Serial alone, but for its range. Serial.resetSerial or the end of the program ends it.
 */
public class LLC {
    private static final int MOST_LOOKS = 10;

    private LLC() {
    }

    /** Begins, and forgets what has come before. */
    public static native void init();

    /** Gives the next byte, 0 to 255, or -1 if none has come. There is room for 64 bytes until they are read. */
    public static native int read();

    /** Sends so many bytes of an array and does not wait. Leave the array alone until all is sent. */
    public static native void write(byte[] bytes, int length);

    /** Says whether bytes are still being sent. */
    public static native boolean isSending();

    /** Says whether the last bytes met others on their way; then the rest of them was not sent. */
    public static native boolean isSendError();

    /** Sends so many bytes of an array, waits for the last one, and says whether it worked. */
    public static boolean sendBytes(byte[] bytes, int length) {
        write(bytes, length);
        while (isSending()) Thread.yield();
        return !isSendError();
    }

    /** Waits a little for the next byte and gives it, or -1 if none has come. */
    public static int receive() {
        for (int look = 0; look < MOST_LOOKS; look++) {
            int value = read();
            if (value >= 0) return value;
            rest();
        }
        return -1;
    }

    /** Lets the light reach far. */
    public static void setRangeLong() {
        Serial.setRangeLong();
    }

    /** Lets the light reach only near bricks. */
    public static void setRangeShort() {
        Serial.setRangeShort();
    }

    /** The sum of the first bytes. */
    static byte sum(byte[] bytes, int length) {
        byte sum = 0;
        for (int index = 0; index < length; index++) sum += bytes[index];
        return sum;
    }

    private static void rest() {
        try {
            Thread.sleep(1);
        } catch (InterruptedException lookAgain) {
            // A byte may be there already.
        }
    }
}
