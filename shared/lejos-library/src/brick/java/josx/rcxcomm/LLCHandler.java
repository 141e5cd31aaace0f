package josx.rcxcomm;

/** Sends and receives packets of one byte and answers to them as plain bytes, with LLC. */
public class LLCHandler extends PacketHandler {
    private static final int PACKET_LENGTH = 3;
    private static final int ANSWER_LENGTH = 2;

    /** The last bits of a packet's first byte say how many bytes of the sender it has. */
    private static final int LENGTH_BITS = 7;

    private final byte[] packet = new byte[PACKET_LENGTH];
    private final byte[] answer = new byte[ANSWER_LENGTH];
    private boolean hasPacket;
    private boolean hasAnswer;

    /** Makes one and begins with LLC. */
    public LLCHandler() {
        LLC.init();
    }

    /** Sends so many bytes, waits for the last one and says whether it worked. */
    public synchronized boolean sendPacket(byte[] bytes, int length) {
        return LLC.sendBytes(bytes, length);
    }

    /** Puts the packet that has come into an array, with its first byte and its sum, and says how many bytes it has. */
    public synchronized int receivePacket(byte[] buffer) {
        hasPacket = false;
        return copy(packet, buffer);
    }

    /** Puts the answer that has come into an array and says how many bytes it has. */
    public synchronized int receiveAck(byte[] buffer) {
        hasAnswer = false;
        return copy(answer, buffer);
    }

    /** Says whether a packet has come. */
    public synchronized boolean isPacketAvailable() {
        if (!hasPacket) look();
        return hasPacket;
    }

    /** Says whether an answer has come. */
    public synchronized boolean isAckAvailable() {
        if (!hasAnswer) look();
        return hasAnswer;
    }

    /** Takes in the next packet or answer, if there is one; bytes that begin neither are lost. */
    private void look() {
        int value = LLC.read();
        while (value >= 0) {
            int length = value & LENGTH_BITS;
            if (length == 0) {
                takeIn(answer, value);
                hasAnswer = true;
                return;
            }
            if (length == 1) {
                takeIn(packet, value);
                hasPacket = true;
                return;
            }
            value = LLC.read();
        }
    }

    private static void takeIn(byte[] buffer, int first) {
        buffer[0] = (byte) first;
        for (int index = 1; index < buffer.length; index++) buffer[index] = (byte) LLC.receive();
    }

    private static int copy(byte[] from, byte[] to) {
        for (int index = 0; index < from.length; index++) to[index] = from[index];
        return from.length;
    }
}
