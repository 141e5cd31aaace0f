package josx.rcxcomm;

/** Sends single bytes until the other brick says that they have come. */
public class F7DeliveryHandler extends PacketHandler {
    private static final int MOST_TRIES = 5;
    private static final int ANSWER_MILLISECONDS = 500;
    private static final int LOOK_MILLISECONDS = 10;

    private final byte[] answer = new byte[1];
    private final byte[] received = new byte[1];
    private boolean hasReceived;

    /** Makes one on top of another. */
    public F7DeliveryHandler(PacketHandler handler) {
        super(handler);
    }

    /** Sends the first byte of the packet and says whether the other brick has answered. */
    public synchronized boolean sendPacket(byte[] packet, int length) {
        for (int tries = 0; tries < MOST_TRIES; tries++) {
            if (lowerHandler.sendPacket(packet, 1) && isAnswered(packet[0])) return true;
        }
        return false;
    }

    /** Puts the byte that has come into an array and says how many there are, 0 or 1. */
    public synchronized int receivePacket(byte[] buffer) {
        if (!hasReceived) return 0;
        hasReceived = false;
        buffer[0] = received[0];
        return 1;
    }

    /** Says whether a byte has come, and answers it. */
    public synchronized boolean isPacketAvailable() {
        if (!hasReceived && lowerHandler.isPacketAvailable() && lowerHandler.receivePacket(received) > 0) {
            answer[0] = (byte) ~received[0];
            hasReceived = lowerHandler.sendPacket(answer, 1);
        }
        return hasReceived;
    }

    /** The other brick answers with all bits turned around. */
    private boolean isAnswered(byte sent) {
        for (int waited = 0; waited < ANSWER_MILLISECONDS; waited += LOOK_MILLISECONDS) {
            if (lowerHandler.isPacketAvailable() && lowerHandler.receivePacket(answer) > 0 && answer[0] == (byte) ~sent) return true;
            try {
                Thread.sleep(LOOK_MILLISECONDS);
            } catch (InterruptedException lookAgain) {
                // The answer may be there already.
            }
        }
        return false;
    }
}
