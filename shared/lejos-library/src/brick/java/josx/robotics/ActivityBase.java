package josx.robotics;

/** A thread that ends with the program, on which activities are built. */
public abstract class ActivityBase extends Thread {
    /** The robot that all activities share. */
    static final SharedRobot robot = new SharedRobot();

    /** Wakes who waits for it when an activity wants the robot, gets it or gives it back; synchronize on it to wait. */
    protected static final Object monitor = robot;

    /** Makes one that does not keep the program from ending. */
    public ActivityBase() {
        setDaemon(true);
    }
}
