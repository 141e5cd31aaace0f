package josx.rcxcomm;

/** Sends and receives packets, usually with the help of a simpler handler below it. */
public abstract class PacketHandler {
    /** The simpler handler, or null. */
    protected PacketHandler lowerHandler;

    /** Makes one that needs no other. */
    public PacketHandler() {
    }

    /** Makes one on top of another. */
    public PacketHandler(PacketHandler handler) {
        lowerHandler = handler;
    }

    /** Sets who sends and who is to receive. */
    public void open(byte source, byte destination) {
        if (lowerHandler != null) lowerHandler.open(source, destination);
    }

    /** Begins to count the packets anew. */
    public void reset() {
        if (lowerHandler != null) lowerHandler.reset();
    }

    /** Does nothing on a brick. */
    public void setListen(boolean isListening) {
    }

    /** Sends so many bytes and says whether it worked. */
    public abstract boolean sendPacket(byte[] packet, int length);

    /** Puts the packet that has come into an array and says how many bytes it has. */
    public abstract int receivePacket(byte[] buffer);

    /** Puts the answer that has come into an array and says how many bytes it has. */
    public int receiveAck(byte[] buffer) {
        return 0;
    }

    /** Says whether a packet has come. */
    public abstract boolean isPacketAvailable();

    /** Says whether an answer has come. */
    public boolean isAckAvailable() {
        return false;
    }

    /** Ends the work. */
    public void close() {
        if (lowerHandler != null) lowerHandler.close();
    }

    /** Gives the number of what went wrong last, 0 if nothing did. */
    public int getError() {
        return lowerHandler == null ? 0 : lowerHandler.getError();
    }
}
