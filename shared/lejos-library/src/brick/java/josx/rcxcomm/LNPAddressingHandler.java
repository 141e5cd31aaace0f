package josx.rcxcomm;

/** Sends packets of LNP to one address, and receives those that come from there. */
public class LNPAddressingHandler extends PacketHandler {
    /** What is before the bytes of the sender: where the packet goes and where it comes from. */
    private static final int ADDRESSES = 2;

    private static final int MOST_BYTES = 255;

    private final byte[] incoming = new byte[MOST_BYTES];
    private final byte[] outgoing = new byte[MOST_BYTES];
    private byte source;
    private byte destination;
    private int waiting;

    /** Makes one on top of an LNPIntegrityHandler whose packets begin with 0xF1. */
    public LNPAddressingHandler(PacketHandler handler) {
        super(handler);
    }

    /** Sets the own address and that of the other brick. */
    public void open(byte source, byte destination) {
        this.source = source;
        this.destination = destination;
    }

    /** Sends so many bytes and says whether it worked; nobody answers. */
    public boolean sendPacket(byte[] packet, int length) {
        outgoing[0] = destination;
        outgoing[1] = source;
        for (int index = 0; index < length; index++) outgoing[index + ADDRESSES] = packet[index];
        return lowerHandler.sendPacket(outgoing, length + ADDRESSES);
    }

    /** Puts the bytes that have come into an array and says how many there are. */
    public int receivePacket(byte[] buffer) {
        int length = waiting;
        for (int index = 0; index < length; index++) buffer[index] = incoming[index + ADDRESSES];
        waiting = 0;
        return length;
    }

    /** Says whether a packet has come from the other address to this one. */
    public boolean isPacketAvailable() {
        while (waiting == 0 && lowerHandler.isPacketAvailable()) {
            int length = lowerHandler.receivePacket(incoming);
            if (length > ADDRESSES && incoming[0] == source && incoming[1] == destination) waiting = length - ADDRESSES;
        }
        return waiting != 0;
    }
}
