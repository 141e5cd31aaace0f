package josx.rcxcomm;

import josx.platform.rcx.Serial;

/** Sends and receives plain bytes of infrared light; Robotran's brick sends those of one call as one packet. */
public class LLC {
    private static final int MOST_LOOKS = 10;

    private static byte[] packet;
    private static int first;
    private static int count;

    private LLC() {
    }

    /** Begins; from then on, leave Serial alone. */
    public static synchronized void init() {
        packet = new byte[16];
        count = 0;
    }

    /** Gives the next byte, 0 to 255, or -1 if none has come. */
    public static synchronized int read() {
        if (count == 0 && Serial.isPacketAvailable()) {
            first = 0;
            count = Serial.readPacket(packet);
        }
        if (count == 0) return -1;
        count--;
        return packet[first++] & 0xFF;
    }

    /** Sends so many bytes of an array and does not wait. */
    public static void write(byte[] bytes, int length) {
        Serial.sendPacket(bytes, 0, length);
    }

    /** Says whether bytes are still being sent. */
    public static boolean isSending() {
        return Serial.isSending();
    }

    /** Says whether the last bytes met others on their way, which here never happens. */
    public static boolean isSendError() {
        return false;
    }

    /** Sends so many bytes of an array, waits for the last one, and says whether it worked. */
    public static boolean sendBytes(byte[] bytes, int length) {
        if (isSending()) return false;
        write(bytes, length);
        while (isSending()) Thread.yield();
        return !isSendError();
    }

    /** Waits a little for the next byte and gives it, or -1 if none has come. */
    public static int receive() {
        for (int look = 0; look < MOST_LOOKS; look++) {
            int value = read();
            if (value >= 0) return value;
            Thread.yield();
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
}
