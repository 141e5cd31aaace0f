package lejos.robotics.subsumption;

/**
 * Chooses among behaviours: of those that want the robot, the last one of the array gets it.
 *
 * <p>The actions are done by the thread that calls start. Another thread asks all the time who wants the robot, and
 * calls suppress of the behaviour that acts if a more important one wants it. A behaviour that still wants the robot
 * when its action is over acts again. Until the first one wants the robot, start waits.
 */
public class Arbitrator {
    private static final int NOBODY = -1;

    private final Behavior[] behaviors;
    private final boolean returnWhenInactive;
    private final Monitor monitor = new Monitor();
    private int active = NOBODY;

    /** Makes one for these behaviours, the least important first. */
    public Arbitrator(Behavior[] behaviorList) {
        this(behaviorList, false);
    }

    /** Makes one for these behaviours, and says whether start is over when nobody wants the robot any more. */
    public Arbitrator(Behavior[] behaviorList, boolean returnWhenInactive) {
        behaviors = behaviorList;
        this.returnWhenInactive = returnWhenInactive;
        monitor.setDaemon(true);
    }

    /** Begins to choose and to act; never ends unless the constructor was told so. */
    public void start() {
        monitor.start();
        while (monitor.winner == NOBODY) Thread.yield();
        while (true) {
            synchronized (monitor) {
                active = monitor.winner;
                if (active == NOBODY && returnWhenInactive) {
                    monitor.isOver = true;
                    return;
                }
            }
            if (active != NOBODY) {
                behaviors[active].action();
                synchronized (monitor) {
                    active = NOBODY;
                }
            }
            Thread.yield();
        }
    }

    /** Asks who wants the robot. */
    private class Monitor extends Thread {
        int winner = NOBODY;
        boolean isOver;

        Monitor() {
        }

        public void run() {
            while (!isOver) {
                synchronized (this) {
                    int asked = behaviors.length - 1;
                    while (asked >= 0 && !behaviors[asked].takeControl()) asked--;
                    winner = asked;
                    if (active != NOBODY && winner > active) behaviors[active].suppress();
                }
                Thread.yield();
            }
        }
    }
}
