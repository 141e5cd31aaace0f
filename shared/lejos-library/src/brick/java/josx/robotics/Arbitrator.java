package josx.robotics;

/**
 * Chooses among behaviours: of those that want the robot, the last one of the array gets it.
 *
 * <p>Whoever loses the robot is told by suppress. A more important behaviour takes over at once and acts as soon as the action before has
 * ended; a less important one has to wait until the action is over, and nobody is asked meanwhile. A behaviour acts once each time it gets
 * the robot, and keeps it until another behaviour wants it.
 */
public class Arbitrator {
    private static final int NOBODY = -1;

    private final Behavior[] behaviors;
    private final Actor actor = new Actor();

    /** Makes one for these behaviours, the least important first. */
    public Arbitrator(Behavior[] behaviors) {
        this.behaviors = behaviors;
    }

    /** Begins to choose, and never ends; the actions are done beside it, in a thread of their own. */
    public void start() {
        actor.start();
        int holder = NOBODY;
        while (true) {
            int winner = winner();
            if (winner != NOBODY && winner != holder) {
                hand(holder, winner);
                holder = winner;
            }
            Thread.yield();
        }
    }

    private int winner() {
        for (int index = behaviors.length - 1; index >= 0; index--) {
            if (behaviors[index].takeControl()) return index;
        }
        return NOBODY;
    }

    private void hand(int from, int to) {
        if (from > to) actor.awaitEnd();
        if (from != NOBODY) behaviors[from].suppress();
        actor.act(behaviors[to]);
    }

    /** Does one action after the other. */
    private static class Actor extends Thread {
        private Behavior next;
        private boolean isActing;

        Actor() {
        }

        public void run() {
            while (true) awaitNext().action();
        }

        /** Lets this behaviour act once the action before has ended. */
        synchronized void act(Behavior behavior) {
            next = behavior;
            notifyAll();
        }

        synchronized void awaitEnd() {
            while (isActing || next != null) rest();
        }

        // Neither this nor rest is private, because private methods lock nothing on a brick.

        /** Waits for a behaviour that is to act. */
        synchronized Behavior awaitNext() {
            isActing = false;
            notifyAll();
            while (next == null) rest();
            Behavior behavior = next;
            next = null;
            isActing = true;
            return behavior;
        }

        void rest() {
            try {
                wait();
            } catch (InterruptedException lookAgain) {
                // What is waited for may have come or not.
            }
        }
    }
}
