package lejos.nxt.comm;

import lejos.util.Delay;

/** Connects robots by cables from port 4 to port 4. One of them connects to the others, which wait for it. */
public class RS485 {
    /** How many bytes go in a packet. */
    public static final int BUFSZ = 128;

    /** How many connections a robot can have, and one more. */
    public static final int MAX_CONNECTIONS = 8;

    private static final int PERIOD = 5;
    private static final int NOTHING = 0;
    private static final int WAITS = 1;
    private static final int CONNECTS = 2;

    private static NXTCommConnector connector;
    private static int role = NOTHING;
    private static int count;
    private static boolean isListening;
    private static boolean isCancelled;

    private RS485() {
    }

    /** Connects to the robot with a name; null if that fails, or if this robot has waited and is connected. */
    public static RS485Connection connect(String target) {
        return connect(target, NXTConnection.PACKET);
    }

    /** Connects to the robot with a name; null if that fails, or if this robot has waited and is connected. */
    public static RS485Connection connect(String target, int mode) {
        if (target == null || !take(CONNECTS)) return null;
        int link = BTLink.openCable(target);
        while (link >= 0 && BTLink.status(link) == BTLink.WAITING) Delay.msDelay(PERIOD);
        if (link >= 0 && BTLink.status(link) == BTLink.OPEN) return new RS485Connection(link);
        free();
        return null;
    }

    /** Waits at most so many milliseconds until another robot connects, 0 for ever; null if none did. */
    public static RS485Connection waitForConnection(int timeout, int mode) {
        if (isListening || !take(WAITS)) return null;
        isListening = true;
        isCancelled = false;
        long end = System.currentTimeMillis() + timeout;
        int link = BTLink.listenCable(mode);
        while (link >= 0 && !isCancelled && (timeout == 0 || System.currentTimeMillis() < end)) {
            if (BTLink.status(link) == BTLink.OPEN) {
                isListening = false;
                return new RS485Connection(link);
            }
            Delay.msDelay(PERIOD);
        }
        if (link >= 0) BTLink.close(link);
        isListening = false;
        free();
        return null;
    }

    /** Lets a thread that waits for a connection wait no longer; says whether one did. */
    public static boolean cancelConnect() {
        isCancelled = true;
        return isListening;
    }

    /** Gives what makes connections. */
    public static NXTCommConnector getConnector() {
        if (connector == null) connector = new Connector();
        return connector;
    }

    static synchronized void free() {
        count--;
        if (count == 0) role = NOTHING;
    }

    /** A robot either connects or waits, as long as it has a connection. */
    private static synchronized boolean take(int wanted) {
        int most = wanted == CONNECTS ? MAX_CONNECTIONS - 1 : MAX_CONNECTIONS;
        if (role != NOTHING && role != wanted || count >= most) return false;
        role = wanted;
        count++;
        return true;
    }

    private static class Connector extends NXTCommConnector {
        Connector() {
        }

        public NXTConnection connect(String target, int mode) {
            return RS485.connect(target, mode);
        }

        public NXTConnection waitForConnection(int timeout, int mode) {
            return RS485.waitForConnection(timeout, mode);
        }

        public boolean cancel() {
            return cancelConnect();
        }
    }
}
