package josx.robotics;

/** A thread that ends with the program, on which activities are built. */
public abstract class ActivityBase extends Thread {
    /** Whoever has it has the robot. */
    protected static final Object monitor = new Object();

    /** Makes one. */
    public ActivityBase() {
        setDaemon(true);
    }
}
