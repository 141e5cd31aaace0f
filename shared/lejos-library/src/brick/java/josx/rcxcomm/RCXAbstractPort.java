package josx.rcxcomm;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** A way to talk to another brick byte by byte. */
public abstract class RCXAbstractPort {
    /** Sends and receives the packets. */
    protected PacketHandler packetHandler;

    private final RCXInputStream input;
    private final RCXOutputStream output;
    private int timeOut;
    private boolean isOpen = true;

    /** Opens a port on top of a handler. */
    public RCXAbstractPort(PacketHandler handler) throws IOException {
        packetHandler = handler;
        input = new RCXInputStream(this);
        output = new RCXOutputStream(handler);
        Receiver receiver = new Receiver();
        receiver.setDaemon(true);
        receiver.start();
    }

    /** Gives what the other brick's bytes are read from. */
    public InputStream getInputStream() {
        return input;
    }

    /** Gives what bytes for the other brick are written to. */
    public OutputStream getOutputStream() {
        return output;
    }

    /** Begins to count the packets anew. */
    public void reset() {
        packetHandler.reset();
    }

    /** Stops receiving. */
    public void close() {
        isOpen = false;
    }

    /** Gives for how many milliseconds reading waits; 0 are for ever. */
    public int getTimeOut() {
        return timeOut;
    }

    /** Sets for how many milliseconds reading waits; 0 are for ever. */
    public void setTimeOut(int milliseconds) {
        timeOut = milliseconds;
    }

    private class Receiver extends Thread {
        private static final int LOOK_MILLISECONDS = 10;
        private final byte[] packet = new byte[8];

        public void run() {
            while (isOpen) {
                receive();
                try {
                    Thread.sleep(LOOK_MILLISECONDS);
                } catch (InterruptedException lookAgain) {
                    // A packet may be there already.
                }
            }
        }

        private void receive() {
            if (!packetHandler.isPacketAvailable()) return;
            int length = packetHandler.receivePacket(packet);
            for (int index = 0; index < length; index++) input.add(packet[index]);
        }
    }
}
