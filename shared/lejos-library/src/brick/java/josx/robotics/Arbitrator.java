package josx.robotics;

/** Chooses among behaviours: of those that want the robot, the last one of the array gets it. */
public class Arbitrator {
    private static final int NONE = 99;

    private final Behavior[] behaviors;
    private final Actions actions = new Actions();
    private int current = NONE;

    /** Makes one for these behaviours, the least important first. */
    public Arbitrator(Behavior[] behaviors) {
        this.behaviors = behaviors;
        actions.start();
    }

    /** Begins to choose, and never ends. */
    public void start() {
        while (true) {
            int wanted = behaviors.length - 1;
            while (wanted >= 0 && !behaviors[wanted].takeControl()) wanted--;
            // An action is done once each time its behaviour gets the robot.
            if (wanted >= 0 && wanted != current) giveTo(wanted);
        }
    }

    private void giveTo(int next) {
        if (current != NONE) {
            // A more important one may finish; a less important one is told to end.
            while (next < current && !actions.isDone) Thread.yield();
            behaviors[current].suppress();
        }
        current = next;
        actions.begin(next);
        Thread.yield();
    }

    /** Does the actions, one at a time. */
    private class Actions extends Thread {
        boolean isDone = true;
        private int wanted = NONE;

        public void run() {
            while (true) {
                act();
                Thread.yield();
            }
        }

        /** Waits for the action that is being done. */
        synchronized void begin(int behavior) {
            wanted = behavior;
        }

        private synchronized void act() {
            if (wanted == NONE) return;
            isDone = false;
            behaviors[wanted].action();
            wanted = NONE;
            isDone = true;
        }
    }
}
