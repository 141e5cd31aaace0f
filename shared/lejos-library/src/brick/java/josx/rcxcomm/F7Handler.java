package josx.rcxcomm;

import josx.platform.rcx.Opcode;
import josx.platform.rcx.Serial;

/** Sends and receives single bytes as LEGO's messages. */
public class F7Handler extends PacketHandler {
    private final byte[] outgoing = {Opcode.OPCODE_SET_MESSAGE, 0};
    private final byte[] incoming = new byte[8];

    /** Makes one. */
    public F7Handler() {
    }

    /** Sends the first byte of the packet. */
    public boolean sendPacket(byte[] packet, int length) {
        outgoing[1] = packet[0];
        while (Serial.isSending()) Thread.yield();
        return Serial.sendPacket(outgoing, 0, 2);
    }

    /** Puts the byte that has come into an array and says how many there are, 0 or 1. */
    public int receivePacket(byte[] buffer) {
        int length = Serial.readPacket(incoming);
        boolean isMessage = (incoming[0] & Opcode.OPCODE_MASK) == (Opcode.OPCODE_SET_MESSAGE & Opcode.OPCODE_MASK);
        if (length < 2 || !isMessage) return 0;
        buffer[0] = incoming[1];
        return 1;
    }

    /** Says whether a packet has come. */
    public boolean isPacketAvailable() {
        return Serial.isPacketAvailable();
    }
}
