package josx.rcxcomm;

/**
 * Sends and receives packets of LNP, the protocol of brickOS, with LLC.
 *
 * <p>A packet begins with 0xF0, or with 0xF1 if it has addresses, and the number of its bytes. Robotran's brick sends it in pieces of up to five
 * bytes, because the ROM takes part; a piece begins with 0xE8 and the number of its bytes.
 */
public class LNPHandler extends PacketHandler {
    /** The first byte of a packet to all. */
    private static final int TO_ALL = 0xF0;

    /** The first byte of a packet with addresses. */
    private static final int WITH_ADDRESSES = 0xF1;

    /** The first byte of a piece, less the number of its bytes. */
    private static final int PIECE = 0xE8;

    private static final int PIECE_LENGTH = 5;
    private static final int PIECE_MILLISECONDS = 50;
    private static final int BYTE = 0xFF;

    /** First byte, length, 255 bytes and sum. */
    private static final int MOST_BYTES = 258;

    private final byte[] packet = new byte[MOST_BYTES];
    private final byte[] piece = new byte[PIECE_LENGTH + 1];
    private int count;
    private boolean hasPacket;

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
        int done = 0;
        while (done < length) {
            if (done > 0) rest();
            int size = length - done < PIECE_LENGTH ? length - done : PIECE_LENGTH;
            piece[0] = (byte) (PIECE | size);
            for (int index = 0; index < size; index++) piece[index + 1] = bytes[done + index];
            if (!LLC.sendBytes(piece, size + 1)) return false;
            done += size;
        }
        return true;
    }

    /** Puts the packet that has come into an array, with first byte, length and sum, and says how many bytes it has. */
    public synchronized int receivePacket(byte[] buffer) {
        if (!hasPacket) return 0;
        int length = count;
        for (int index = 0; index < length; index++) buffer[index] = packet[index];
        hasPacket = false;
        count = 0;
        return length;
    }

    /** Says whether a packet has come. */
    public synchronized boolean isPacketAvailable() {
        while (!hasPacket) {
            int head = LLC.read();
            if (head < 0) return false;
            int size = head - PIECE;
            if (size < 1 || size > PIECE_LENGTH) continue;
            for (int index = 0; index < size; index++) takeIn(LLC.receive());
            LLC.receive();
        }
        return true;
    }

    /** The other brick has to take a piece before the next one comes. */
    private static void rest() {
        try {
            Thread.sleep(PIECE_MILLISECONDS);
        } catch (InterruptedException soonerThanUsual) {
            // The other brick may be quick enough.
        }
    }

    /** Bytes that come before the first byte of a packet or behind its last are lost. */
    private void takeIn(int value) {
        if (hasPacket) return;
        if (count == 0 && value != TO_ALL && value != WITH_ADDRESSES) return;
        packet[count++] = (byte) value;
        hasPacket = count > 1 && count == (packet[1] & BYTE) + 3;
    }
}
