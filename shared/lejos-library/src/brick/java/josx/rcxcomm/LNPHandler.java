package josx.rcxcomm;

/**
 * Sends and receives packets of LNP, the protocol of brickOS, with LLC.
 *
 * <p>A packet begins with 0xF0, or with 0xF1 if it has addresses, and the number of its bytes. After these bytes comes their sum.
 */
public class LNPHandler extends PacketHandler {
    /** The first byte of a packet to all. */
    private static final int TO_ALL = 0xF0;

    /** The first byte of a packet with addresses. */
    private static final int WITH_ADDRESSES = 0xF1;

    private static final int BYTE = 0xFF;

    /** First byte, length, 255 bytes and sum. */
    private static final int MOST_BYTES = 258;

    private final byte[] packet = new byte[MOST_BYTES];
    private int count;

    /** Makes one and begins with LLC. */
    public LNPHandler() {
        LLC.init();
    }

    /** Says whether the packet that came last has addresses. */
    public boolean isAddressing() {
        return (packet[0] & BYTE) == WITH_ADDRESSES;
    }

    /** Sends so many bytes and says whether it worked. */
    public synchronized boolean sendPacket(byte[] bytes, int length) {
        return LLC.sendBytes(bytes, length);
    }

    /** Puts the packet that has come into an array, with first byte, length and sum, and says how many bytes it has. */
    public synchronized int receivePacket(byte[] buffer) {
        int length = count;
        for (int index = 0; index < length; index++) buffer[index] = packet[index];
        count = 0;
        return length;
    }

    /** Says whether a packet has come; waits for the rest of one that has begun. */
    public synchronized boolean isPacketAvailable() {
        while (count == 0) {
            int head = LLC.read();
            if (head < 0) return false;
            if (head == TO_ALL || head == WITH_ADDRESSES) takeIn(head);
        }
        return true;
    }

    /** Takes in the rest of a packet; one that breaks off is lost. */
    private void takeIn(int head) {
        int length = LLC.receive();
        if (length < 0) return;
        packet[0] = (byte) head;
        packet[1] = (byte) length;
        for (int index = 2; index < length + 3; index++) {
            int value = LLC.receive();
            if (value < 0) return;
            packet[index] = (byte) value;
        }
        count = length + 3;
    }
}
