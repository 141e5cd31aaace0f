package lejos.nxt.comm;

/** Makes connections to other robots. */
public abstract class NXTCommConnector {
    /** Makes one. */
    public NXTCommConnector() {
    }

    /** Connects to the robot with a name; null if that fails. */
    public abstract NXTConnection connect(String target, int mode);

    /** Waits at most so many milliseconds until another robot connects, 0 for ever; null if none did. */
    public abstract NXTConnection waitForConnection(int timeout, int mode);

    /** Lets a thread that waits wait no longer. */
    public abstract boolean cancel();
}
