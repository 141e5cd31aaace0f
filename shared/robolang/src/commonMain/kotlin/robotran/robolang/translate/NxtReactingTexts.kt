package robotran.robolang.translate

/**
 * The Java of programs with behaviours for an NXT. The Arbitrator of leJOS NXJ works otherwise than that of leJOS for
 * the RCX: here the program chooses itself, in the way that Robolang's behaviours do on both.
 */
internal object NxtReactingTexts {
    /** The list of behaviours replaces `ALL`, lowest priority first. */
    const val REACTIONS = """/** Looks all the time whether a behaviour is to take over: of those that want the robot, the last one. */
static class Reactions extends Thread {
    public void run() {
        watchingThread = this;
        Behavior[] behaviours = {ALL};
        Actions actions = new Actions();
        actions.start();
        int holder = -1;
        while (true) {
            int winner = behaviours.length - 1;
            while (winner >= 0 && !behaviours[winner].takeControl()) winner--;
            if (winner >= 0 && winner != holder) {
                if (holder > winner) actions.awaitEnd();
                if (holder >= 0) behaviours[holder].suppress();
                actions.act(behaviours[winner]);
                holder = winner;
            }
            Thread.yield();
        }
    }
}

/** Does one action after the other. */
static class Actions extends Thread {
    private Behavior next;
    private boolean isActing;

    public void run() {
        while (true) awaitNext().action();
    }

    synchronized void act(Behavior behaviour) {
        next = behaviour;
        notifyAll();
    }

    synchronized void awaitEnd() {
        while (isActing || next != null) rest();
    }

    private synchronized Behavior awaitNext() {
        isActing = false;
        notifyAll();
        while (next == null) rest();
        Behavior behaviour = next;
        next = null;
        isActing = true;
        return behaviour;
    }

    private void rest() {
        try {
            wait();
        } catch (InterruptedException lookAgain) {
            // What is waited for may have come or not.
        }
    }
}"""
}
