package josx.rcxcomm;

import java.io.IOException;

/** Talks to one of several bricks with LNP, the protocol of brickOS; bytes can get lost. */
public class RCXLNPAddressingPort extends RCXAbstractPort {
    /** Opens the port with the own address and that of the other brick. */
    public RCXLNPAddressingPort(byte source, byte destination) throws IOException {
        super(new LNPAddressingHandler(new LNPIntegrityHandler(new LNPHandler(), (byte) 0xF1)));
        packetHandler.open(source, destination);
    }
}
