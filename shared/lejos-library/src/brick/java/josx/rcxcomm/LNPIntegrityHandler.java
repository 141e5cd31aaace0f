package josx.rcxcomm;

/** Adds a sum to packets of LNP, and drops those that come with a wrong one. */
public class LNPIntegrityHandler extends PacketHandler {
    /** First byte, length, 255 bytes and sum. */
    private static final int MOST_BYTES = 258;

    /** What is in a packet besides the bytes of the sender: first byte, length and sum. */
    private static final int MORE_BYTES = 3;

    private final byte[] incoming = new byte[MOST_BYTES];
    private final byte[] outgoing = new byte[MOST_BYTES];
    private byte op;
    private boolean isAddressing;
    private int waiting;

    /** Makes one on top of an LNPHandler; its packets begin with this byte: 0xF0 to all, 0xF1 with addresses. */
    public LNPIntegrityHandler(PacketHandler handler, byte op) {
        super(handler);
        this.op = op;
    }

    /** Says whether the packet that came last has addresses. */
    public boolean isAddressing() {
        return isAddressing;
    }

    /** Sets the first byte of the packets to be sent: 0xF0 to all, 0xF1 with addresses. */
    public void setOp(byte op) {
        this.op = op;
    }

    /** Sends so many bytes and says whether it worked; nobody answers. */
    public boolean sendPacket(byte[] packet, int length) {
        outgoing[0] = op;
        outgoing[1] = (byte) length;
        for (int index = 0; index < length; index++) outgoing[index + 2] = packet[index];
        outgoing[length + 2] = sum(outgoing, length + 2);
        return lowerHandler.sendPacket(outgoing, length + MORE_BYTES);
    }

    /** Puts the bytes that have come into an array and says how many there are. */
    public int receivePacket(byte[] buffer) {
        int length = waiting == 0 ? 0 : waiting - MORE_BYTES;
        for (int index = 0; index < length; index++) buffer[index] = incoming[index + 2];
        waiting = 0;
        return length;
    }

    /** Says whether a packet with the right sum has come. */
    public boolean isPacketAvailable() {
        while (waiting == 0 && lowerHandler.isPacketAvailable()) {
            int length = lowerHandler.receivePacket(incoming);
            if (length < MORE_BYTES || incoming[length - 1] != sum(incoming, length - 1)) continue;
            isAddressing = (incoming[0] & 1) == 1;
            waiting = length;
        }
        return waiting != 0;
    }

    /** LNP begins to add at -1. */
    private static byte sum(byte[] bytes, int count) {
        return (byte) (LLC.sum(bytes, count) - 1);
    }
}
