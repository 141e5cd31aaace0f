package josx.platform.rcx;

/** Sends small numbers to other bricks and gets theirs, as LEGO's own programs do. */
public class Message implements Opcode {
    private static final byte[] outgoing = {OPCODE_SET_MESSAGE, 0};
    private static final byte[] incoming = new byte[8];

    private static byte message;

    private Message() {
    }

    /** Sends a number to all bricks that can see this one. */
    public static void send(byte number) {
        synchronized (outgoing) {
            outgoing[1] = number;
            while (!Serial.sendPacket(outgoing, 0, 2)) Thread.yield();
        }
    }

    /** Gives the number that came last, or 0 if there was none. */
    public static byte get() {
        receive();
        return message;
    }

    /** Forgets the number that came last. */
    public static void clear() {
        receive();
        message = 0;
    }

    /** Says whether a number other than 0 has come. */
    public static boolean isAvailable() {
        receive();
        return message != 0;
    }

    private static void receive() {
        synchronized (incoming) {
            while (Serial.isPacketAvailable()) {
                int length = Serial.readPacket(incoming);
                // Each second packet has one bit turned around, to tell it from the one before.
                boolean isMessage = (incoming[0] & Opcode.OPCODE_MASK) == (Opcode.OPCODE_SET_MESSAGE & Opcode.OPCODE_MASK);
                if (length >= 2 && isMessage) message = incoming[1];
            }
        }
    }
}
