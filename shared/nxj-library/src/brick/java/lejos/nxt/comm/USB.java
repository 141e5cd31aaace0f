package lejos.nxt.comm;

import lejos.util.Delay;

/** Waits for a computer at the other end of a cable; here nobody connects. */
public class USB {
    private static final int PERIOD = 20;

    private static final Connector connector = new Connector();
    private static boolean isCancelled;

    private USB() {
    }

    /** Waits until a computer connects. */
    public static USBConnection waitForConnection() {
        return waitForConnection(0, NXTConnection.PACKET);
    }

    /** Waits at most so many milliseconds until a computer connects, 0 for ever; null if none did. */
    public static USBConnection waitForConnection(int timeout, int mode) {
        long end = System.currentTimeMillis() + timeout;
        isCancelled = false;
        while (!isCancelled && (timeout == 0 || System.currentTimeMillis() < end)) Delay.msDelay(PERIOD);
        return null;
    }

    /** Lets a thread that waits for a connection wait no longer. */
    public static boolean cancelConnect() {
        isCancelled = true;
        return true;
    }

    /** Gives what makes connections; here it waits until its time is over. */
    public static NXTCommConnector getConnector() {
        return connector;
    }

    private static class Connector extends NXTCommConnector {
        Connector() {
        }

        public NXTConnection connect(String target, int mode) {
            return null;
        }

        public NXTConnection waitForConnection(int timeout, int mode) {
            return USB.waitForConnection(timeout, mode);
        }

        public boolean cancel() {
            return cancelConnect();
        }
    }
}
