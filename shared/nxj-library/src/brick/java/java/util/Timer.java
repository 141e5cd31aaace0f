package java.util;

/** Does tasks later, once or again and again, in a thread of its own. */
public class Timer {
    private final Vector<TimerTask> tasks = new Vector<TimerTask>();
    private boolean isCancelled;

    /** Makes one; the program does not end before cancel is called. */
    public Timer() {
        this(false);
    }

    /** Makes one, and says whether the program may end before cancel is called. */
    public Timer(boolean isDaemon) {
        this("Timer", isDaemon);
    }

    /** Makes one whose thread has a name; the program does not end before cancel is called. */
    public Timer(String name) {
        this(name, false);
    }

    /** Makes one whose thread has a name, and says whether the program may end before cancel is called. */
    public Timer(String name, boolean isDaemon) {
        Thread worker = new Worker();
        worker.setName(name);
        worker.setDaemon(isDaemon);
        worker.start();
    }

    /** Does a task once, after so many milliseconds. */
    public void schedule(TimerTask task, long delay) {
        add(task, delay, 0, false);
    }

    /** Does a task after so many milliseconds, and then again and again, with so many between one and the next. */
    public void schedule(TimerTask task, long delay, long period) {
        if (period <= 0) throw new IllegalArgumentException();
        add(task, delay, period, false);
    }

    /** Does a task after so many milliseconds, and then again and again; what was late is made up for. */
    public void scheduleAtFixedRate(TimerTask task, long delay, long period) {
        if (period <= 0) throw new IllegalArgumentException();
        add(task, delay, period, true);
    }

    /** Forgets the tasks that were cancelled, and gives how many there were. */
    public int purge() {
        synchronized (tasks) {
            int count = 0;
            for (int index = tasks.size() - 1; index >= 0; index--) {
                if (tasks.elementAt(index).isCancelled) {
                    tasks.removeElementAt(index);
                    count++;
                }
            }
            return count;
        }
    }

    /** Lets the timer do nothing any more. */
    public void cancel() {
        synchronized (tasks) {
            isCancelled = true;
            tasks.removeAllElements();
            tasks.notifyAll();
        }
    }

    private void add(TimerTask task, long delay, long period, boolean isAtFixedRate) {
        if (delay < 0) throw new IllegalArgumentException();
        synchronized (tasks) {
            if (isCancelled || task.isCancelled) throw new IllegalStateException();
            task.time = System.currentTimeMillis() + delay;
            task.period = period;
            task.isAtFixedRate = isAtFixedRate;
            tasks.addElement(task);
            tasks.notifyAll();
        }
    }

    private class Worker extends Thread {
        Worker() {
        }

        public void run() {
            while (true) {
                TimerTask task;
                try {
                    task = awaitNext();
                } catch (InterruptedException lookAgain) {
                    continue;
                }
                if (task == null) return;
                task.run();
            }
        }

        /** Waits until a task is due; null when the timer is cancelled. */
        private TimerTask awaitNext() throws InterruptedException {
            synchronized (tasks) {
                while (!isCancelled) {
                    TimerTask next = next();
                    long now = System.currentTimeMillis();
                    if (next == null) {
                        tasks.wait();
                    } else if (next.time > now) {
                        tasks.wait(next.time - now);
                    } else {
                        if (next.period > 0) {
                            next.time = (next.isAtFixedRate ? next.time : now) + next.period;
                        } else {
                            tasks.removeElement(next);
                        }
                        return next;
                    }
                }
                return null;
            }
        }

        private TimerTask next() {
            TimerTask next = null;
            for (int index = tasks.size() - 1; index >= 0; index--) {
                TimerTask task = tasks.elementAt(index);
                if (task.isCancelled) {
                    tasks.removeElementAt(index);
                } else if (next == null || task.time <= next.time) {
                    next = task;
                }
            }
            return next;
        }
    }
}
