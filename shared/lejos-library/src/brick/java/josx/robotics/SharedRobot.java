package josx.robotics;

/** The one robot that all activities share: it knows who has it and who waits for it. */
final class SharedRobot {
    // Thrown again and again, since a brick never takes back the memory of a new one.
    private final StopException stop = new StopException();
    private final InterruptedException again = new InterruptedException();

    private Activity holder;

    /** Who asked for it, the first one first. */
    private Activity queue;

    synchronized void ask(Activity activity) {
        if (activity == holder) {
            activity.isCalledAgain = true;
        } else if (!activity.isWaiting) {
            activity.isWaiting = true;
            enqueue(activity);
        }
        notifyAll();
    }

    synchronized void forgetCall(Activity activity) {
        activity.isCalledAgain = false;
    }

    /** Returns when the activity has the robot. */
    synchronized void await(Activity activity) {
        // Now that it has started, it counts.
        notifyAll();
        while (holder != null || first() != activity) {
            try {
                wait();
            } catch (InterruptedException lookAgain) {
                // It may be its turn or not.
            }
        }
        dequeue(activity);
        activity.isWaiting = false;
        holder = activity;
    }

    synchronized void giveBack() {
        holder = null;
        notifyAll();
    }

    /** Lets the holder keep the robot for so long, if nothing comes between. */
    synchronized void keep(Activity activity, int milliseconds) throws InterruptedException, StopException {
        int end = (int) System.currentTimeMillis() + milliseconds;
        while (true) {
            Activity rival = first();
            if (rival != null && rival.getPriority() > activity.getPriority()) throw stop;
            if (activity.isCalledAgain) {
                activity.isCalledAgain = false;
                throw again;
            }
            int rest = end - (int) System.currentTimeMillis();
            if (rest <= 0) return;
            wait(rest);
        }
    }

    /** The most important of those that wait; one that has not started cannot. */
    private Activity first() {
        Activity best = null;
        for (Activity each = queue; each != null; each = each.behind) {
            if (each.isAlive() && (best == null || each.getPriority() > best.getPriority())) best = each;
        }
        return best;
    }

    private void enqueue(Activity activity) {
        activity.behind = null;
        if (queue == null) {
            queue = activity;
        } else {
            Activity last = queue;
            while (last.behind != null) last = last.behind;
            last.behind = activity;
        }
    }

    private void dequeue(Activity activity) {
        if (queue == activity) {
            queue = activity.behind;
        } else {
            Activity before = queue;
            while (before.behind != activity) before = before.behind;
            before.behind = activity.behind;
        }
    }
}
