package josx.robotics;

/** A thread that ends with the program, on which activities are built. */
public abstract class ActivityBase extends Thread {
    /** Makes one that does not keep the program from ending. */
    public ActivityBase() {
        setDaemon(true);
    }
}
