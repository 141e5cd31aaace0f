package lejos.nxt.comm;

import javax.bluetooth.RemoteDevice;
import lejos.util.Delay;

/** Connects robots by radio. */
public class Bluetooth {
    private static final int PERIOD = 20;
    private static final int LONGEST_NAME = 16;

    private static final Connector connector = new Connector();
    private static boolean isCancelled;

    private Bluetooth() {
    }

    /** Connects to another robot; null if that fails. */
    public static BTConnection connect(RemoteDevice remoteDevice) {
        return connect(remoteDevice, NXTConnection.PACKET);
    }

    /**
     * Connects to another robot; null if that fails.
     *
     * @hidden
     */
    public static BTConnection connect(RemoteDevice remoteDevice, int mode) {
        return remoteDevice == null ? null : connect(remoteDevice.getFriendlyName(false), mode);
    }

    /** Connects to the robot with a name; null if that fails. */
    public static BTConnection connect(String target, int mode) {
        int link = BTLink.open(target);
        if (link < 0) return null;
        while (BTLink.status(link) == BTLink.WAITING) Delay.msDelay(PERIOD);
        return BTLink.status(link) == BTLink.OPEN ? new BTConnection(link) : null;
    }

    /** Waits until another robot connects. */
    public static BTConnection waitForConnection() {
        return waitForConnection(0, NXTConnection.PACKET);
    }

    /** Waits at most so many milliseconds until another robot connects, 0 for ever; null if none did. */
    public static BTConnection waitForConnection(int timeout, int mode) {
        long end = System.currentTimeMillis() + timeout;
        isCancelled = false;
        int link = BTLink.listen(mode);
        if (link < 0) return null;
        while (!isCancelled && (timeout == 0 || System.currentTimeMillis() < end)) {
            if (BTLink.status(link) == BTLink.OPEN) return new BTConnection(link);
            Delay.msDelay(PERIOD);
        }
        BTLink.close(link);
        return null;
    }

    /** Lets a thread that waits for a connection wait no longer. */
    public static boolean cancelConnect() {
        isCancelled = true;
        return true;
    }

    /** Gives the robot with a name; null if there is none. */
    public static RemoteDevice getKnownDevice(String name) {
        return BTLink.isKnown(name) ? new Device(name) : null;
    }

    /** Gives the name of this robot. */
    public static String getFriendlyName() {
        byte[] name = new byte[LONGEST_NAME];
        return new String(name, 0, BTLink.name(name));
    }

    /** Gives the address of this robot, which is its name here. */
    public static String getLocalAddress() {
        return getFriendlyName();
    }

    /** Gives what makes connections. */
    public static NXTCommConnector getConnector() {
        return connector;
    }

    private static class Device extends RemoteDevice {
        Device(String name) {
            super(name);
        }
    }

    private static class Connector extends NXTCommConnector {
        Connector() {
        }

        public NXTConnection connect(String target, int mode) {
            return Bluetooth.connect(target, mode);
        }

        public NXTConnection waitForConnection(int timeout, int mode) {
            return Bluetooth.waitForConnection(timeout, mode);
        }

        public boolean cancel() {
            return cancelConnect();
        }
    }
}
