package lejos.nxt.comm;

/** Makes connections to other robots. */
public interface NXTCommConnector {
    /** Connects to the robot with a name; null if that fails. */
    NXTConnection connect(String target, int mode);

    /** Waits at most so many milliseconds until another robot connects, 0 for ever; null if none did. */
    NXTConnection waitForConnection(int timeout, int mode);

    /** Lets a thread that waits wait no longer. */
    boolean cancel();
}
