package josx.rcxcomm;

import josx.platform.rcx.Serial;

/**
 * Sends and receives plain bytes of infrared light; Robotran's brick sends those of one call as one packet.
 *
 * <p>Its ROM takes part: it adds the sum of the bytes to what is sent, and takes in only what looks like a message of LEGO's: a first byte that
 * says how many follow, as many bytes, and the sum of all. Other bytes are lost. What LLCHandler sends looks like that.
 */
public class LLC {
    private static final int MOST_LOOKS = 10;
    private static final int BYTE = 0xFF;

    // Whoever reads locks it. The last byte in it is the sum, which the ROM keeps to itself.
    private static final byte[] packet = new byte[16];
    private static int first;
    private static int count;

    private LLC() {
    }

    /** Begins; from then on, leave Serial alone. */
    public static void init() {
        synchronized (packet) {
            count = 0;
        }
    }

    /** Gives the next byte, 0 to 255, or -1 if none has come. */
    public static int read() {
        synchronized (packet) {
            if (count == 0 && Serial.isPacketAvailable()) fill();
            if (count == 0) return -1;
            count--;
            return packet[first++] & BYTE;
        }
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

    /** The same for bytes of which the last one may be the sum of the others: that one the ROM adds itself. */
    static boolean sendMessage(byte[] bytes, int length) {
        return sendBytes(bytes, length > 1 && bytes[length - 1] == sum(bytes, length - 1) ? length - 1 : length);
    }

    /** The sum of the first bytes. */
    static byte sum(byte[] bytes, int length) {
        byte sum = 0;
        for (int index = 0; index < length; index++) sum += bytes[index];
        return sum;
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

    private static void fill() {
        int length = Serial.readPacket(packet);
        if (length <= 0) return;
        packet[length] = sum(packet, length);
        first = 0;
        count = length + 1;
    }
}
