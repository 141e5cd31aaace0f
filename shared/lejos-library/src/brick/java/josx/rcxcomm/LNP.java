package josx.rcxcomm;

/**
 * Sends packets to bricks with LNP, the protocol of brickOS, and tells listeners of those that come.
 *
 * <p>An address is a brick, a multiple of 16, plus a port. Nobody answers a packet, so that some get lost.
 */
public class LNP extends Thread {
    private static final byte TO_ALL = (byte) 0xF0;
    private static final byte WITH_ADDRESSES = (byte) 0xF1;
    private static final int BRICK_BITS = 0xF0;
    private static final int PORT_BITS = 0x0F;
    private static final int ADDRESSES = 2;
    private static final int MOST_PORTS = 4;
    private static final int MOST_HANDLERS = 4;
    private static final int MOST_BYTES = 255;
    private static final int LOOK_MILLISECONDS = 10;

    private static final LNPIntegrityHandler link = new LNPIntegrityHandler(new LNPHandler(), TO_ALL);
    private static final byte[] incoming = new byte[MOST_BYTES];
    private static final byte[] outgoing = new byte[MOST_BYTES];

    private static final IntegrityHandler[] handlersOfAll = new IntegrityHandler[MOST_HANDLERS];
    private static int countOfAll;

    // Those of port 0, then those of port 1 and so on: a brick cannot make arrays of arrays of objects at once.
    private static final AddressingHandler[] handlersOfPorts = new AddressingHandler[MOST_PORTS * MOST_HANDLERS];
    private static final int[] countsOfPorts = new int[MOST_PORTS];

    private static byte ownAddress;

    private LNP() {
        setDaemon(true);
    }

    /** Sends so many bytes, 253 at most, to an address, with the own address for the answer; says whether it worked. */
    public static boolean addressingWrite(byte[] packet, int length, byte destination, byte source) {
        synchronized (outgoing) {
            outgoing[0] = destination;
            outgoing[1] = source;
            for (int index = 0; index < length; index++) outgoing[index + ADDRESSES] = packet[index];
            link.setOp(WITH_ADDRESSES);
            return link.sendPacket(outgoing, length + ADDRESSES);
        }
    }

    /** Sends so many bytes, 255 at most, to all bricks, and says whether it worked. */
    public static boolean integrityWrite(byte[] packet, int length) {
        synchronized (outgoing) {
            link.setOp(TO_ALL);
            return link.sendPacket(packet, length);
        }
    }

    /** Tells a handler from now on of packets to all bricks; there can be four. */
    public static void addIntegrityHandler(IntegrityHandler handler) {
        synchronized (incoming) {
            handlersOfAll[countOfAll] = handler;
            countOfAll++;
        }
    }

    /** Tells a handler from now on of packets to a port of this brick, 0 to 3; there can be four for each. */
    public static void addAddressingHandler(AddressingHandler handler, byte port) {
        synchronized (incoming) {
            handlersOfPorts[port * MOST_HANDLERS + countsOfPorts[port]] = handler;
            countsOfPorts[port]++;
        }
    }

    /** Begins to receive packets to all bricks and to the brick with this address, a multiple of 16. */
    public static void startListening(byte address) {
        ownAddress = address;
        new LNP().start();
    }

    /** Receives packets for ever and tells the handlers. */
    public void run() {
        while (true) {
            while (link.isPacketAvailable()) tell(link.receivePacket(incoming));
            try {
                sleep(LOOK_MILLISECONDS);
            } catch (InterruptedException lookAgain) {
                // A packet may be there already.
            }
        }
    }

    private static void tell(int length) {
        if (!link.isAddressing()) {
            for (int index = 0; index < countOfAll; index++) handlersOfAll[index].processIntegrityPacket(incoming, length);
            return;
        }
        int port = incoming[0] & PORT_BITS;
        if (length < ADDRESSES || (byte) (incoming[0] & BRICK_BITS) != ownAddress || port >= MOST_PORTS) return;
        byte source = incoming[1];
        for (int index = ADDRESSES; index < length; index++) incoming[index - ADDRESSES] = incoming[index];
        for (int index = 0; index < countsOfPorts[port]; index++) {
            handlersOfPorts[port * MOST_HANDLERS + index].processAddressingPacket(incoming, length - ADDRESSES, source);
        }
    }
}
