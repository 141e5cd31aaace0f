package josx.robotics;

/** Something a robot does when it wants to and nothing with a higher priority wants to; only one activity has the robot at a time. */
public abstract class Activity extends ActivityBase {
    private static final StopException stop = new StopException();

    private static Activity chosen;

    /** Makes one; set its priority and call start. */
    public Activity() {
    }

    /** Does what the activity is for; in it, call pause instead of sleep. */
    protected abstract void action() throws StopException;

    /** Is called when the activity is at rest; one in the background can ask here for its next turn. */
    protected void resetRunnable() {
        if (chosen == this) chosen = null;
    }

    /** Asks for the robot: it gets it unless an activity with a higher priority has it. */
    protected final void iWantToRun() {
        synchronized (monitor) {
            if (chosen != null && chosen.getPriority() > getPriority()) return;
            chosen = this;
            interrupt();
            monitor.notifyAll();
        }
    }

    /** Does the action each time the activity gets the robot. */
    public final void run() {
        synchronized (monitor) {
            while (true) act();
        }
    }

    /** Lets time pass; fails if the activity wants to begin again or another takes the robot. */
    protected final void pause(long milliseconds) throws InterruptedException, StopException {
        monitor.wait(milliseconds);
        if (chosen != this) throw stop;
    }

    /** Stands still until an activity wants the robot; fails if the activity wants to begin again or another takes the robot. */
    protected final void pause() throws InterruptedException, StopException {
        monitor.wait();
        if (chosen != this) throw stop;
    }

    private void act() {
        try {
            resetRunnable();
            awaitTurn();
            action();
            monitor.notifyAll();
        } catch (StopException anotherHasTheRobot) {
            // Wait for the next turn.
        }
    }

    private void awaitTurn() throws StopException {
        try {
            pause();
        } catch (InterruptedException itIsOurTurn) {
            // iWantToRun woke this thread.
        }
    }
}
