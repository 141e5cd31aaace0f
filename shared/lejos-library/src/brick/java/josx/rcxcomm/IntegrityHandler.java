package josx.rcxcomm;

/** Is told when a packet of LNP to all bricks has come. */
public interface IntegrityHandler {
    /** Is called with the packet's bytes and how many there are. */
    void processIntegrityPacket(byte[] packet, int length);
}
