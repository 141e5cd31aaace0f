package josx.rcxcomm;

/**
 * Sends single bytes until the other brick has answered, so that none is lost and none comes twice.
 *
 * <p>Its packets have a first byte, the byte of the sender and the sum of both. One bit of the first byte changes from packet to packet. The
 * answer is that first byte without the length, twice.
 */
public class LLCReliableHandler extends PacketHandler {
    /** The first byte of a packet of no bytes. */
    private static final int HEAD = 0xF0;

    /** The bit that changes from packet to packet. */
    private static final int TURN = 0x08;

    /** What of the first byte is answered. */
    private static final int ANSWERED = 0xF8;

    private static final int ANSWER_MILLISECONDS = 500;
    private static final int MOST_BYTES = 3;

    private final byte[] outgoing = new byte[MOST_BYTES];
    private final byte[] incoming = new byte[MOST_BYTES];
    private final byte[] answer = new byte[2];
    private final byte[] answered = new byte[2];

    /** The bit of the next packet to send and of the next one to come. */
    private int turn;
    private int expected;

    /** How many bytes of the sender wait in `incoming`. */
    private int waiting;

    /** Makes one on top of another, which should be an LLCHandler. */
    public LLCReliableHandler(PacketHandler handler) {
        super(handler);
    }

    /** Begins to count the packets anew. */
    public void reset() {
        turn = 0;
        expected = 0;
        lowerHandler.reset();
    }

    /** Sends a packet, one byte at most, and waits until the other brick has answered, for ever if need be. */
    public boolean sendPacket(byte[] packet, int length) {
        outgoing[0] = (byte) (HEAD | turn | length);
        for (int index = 0; index < length; index++) outgoing[index + 1] = packet[index];
        outgoing[length + 1] = LLC.sum(outgoing, length + 1);
        do {
            lowerHandler.sendPacket(outgoing, length + 2);
        } while (!isAnswered((byte) (outgoing[0] & ANSWERED)));
        turn ^= TURN;
        return true;
    }

    /** Puts the bytes that have come into an array and says how many there are. */
    public int receivePacket(byte[] buffer) {
        int length = waiting;
        for (int index = 0; index < length; index++) buffer[index] = incoming[index + 1];
        waiting = 0;
        return length;
    }

    /** Says whether a packet has come, and answers it; one that comes again is only answered. */
    public boolean isPacketAvailable() {
        while (waiting == 0 && lowerHandler.isPacketAvailable()) {
            int length = lowerHandler.receivePacket(incoming);
            if (length < 2 || incoming[length - 1] != LLC.sum(incoming, length - 1)) continue;
            answer[0] = (byte) (incoming[0] & ANSWERED);
            answer[1] = answer[0];
            lowerHandler.sendPacket(answer, 2);
            if ((incoming[0] & TURN) != expected) continue;
            expected ^= TURN;
            waiting = length - 2;
        }
        return waiting != 0;
    }

    private boolean isAnswered(byte wanted) {
        int end = (int) System.currentTimeMillis() + ANSWER_MILLISECONDS;
        while ((int) System.currentTimeMillis() < end) {
            if (lowerHandler.isAckAvailable()) {
                int length = lowerHandler.receiveAck(answered);
                if (length == 2 && answered[0] == wanted && answered[1] == wanted) return true;
            }
            Thread.yield();
        }
        return false;
    }
}
