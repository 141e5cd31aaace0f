package josx.platform.rcx;

/** Is told when a packet of infrared light has come. */
public interface SerialListener {
    /** Is called with the packet's bytes and how many there are. */
    void packetAvailable(byte[] packet, int length);
}
