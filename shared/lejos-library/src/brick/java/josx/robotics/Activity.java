package josx.robotics;

/**
 * Something a robot does when it wants to and nothing with a higher priority wants to; only one activity has the robot at a time.
 *
 * <p>How important an activity is says the priority of its thread. Of equals, who asked first is first.
 */
public abstract class Activity extends ActivityBase {
    /** An hour, in milliseconds. */
    private static final int LONG = 3600000;

    /** Whether it asked for the robot and has not got it yet. */
    boolean isWaiting;

    /** Whether it asked for the robot while it had it. */
    boolean isCalledAgain;

    /** Who asked after this one. */
    Activity behind;

    /** Makes one; set its priority and call start. */
    public Activity() {
    }

    /** Does what the activity is for; in it, call pause instead of sleep. */
    protected abstract void action() throws StopException;

    /** Is called before the activity waits for the robot; one that always wants it can call iWantToRun here. */
    protected void resetRunnable() {
        robot.forgetCall(this);
    }

    /** Asks for the robot: the activity gets it when nothing more important wants it. */
    protected final void iWantToRun() {
        robot.ask(this);
    }

    /** Does the action each time the activity gets the robot. */
    public final void run() {
        while (true) {
            resetRunnable();
            robot.await(this);
            try {
                action();
            } catch (StopException another) {
                // A more important activity has its turn now.
            } finally {
                robot.giveBack();
            }
        }
    }

    /** Lets time pass; fails if the activity is to begin again or to give the robot away. */
    protected final void pause(long milliseconds) throws InterruptedException, StopException {
        robot.keep(this, (int) milliseconds);
    }

    /** Stands still until the activity is to begin again or to give the robot away, and fails then. */
    protected final void pause() throws InterruptedException, StopException {
        while (true) robot.keep(this, LONG);
    }
}
