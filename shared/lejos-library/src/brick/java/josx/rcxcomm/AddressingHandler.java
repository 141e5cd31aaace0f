package josx.rcxcomm;

/** Is told when a packet of LNP has come to a port of this brick. */
public interface AddressingHandler {
    /** Is called with the packet's bytes, how many there are, and the address to answer to. */
    void processAddressingPacket(byte[] packet, int length, byte source);
}
