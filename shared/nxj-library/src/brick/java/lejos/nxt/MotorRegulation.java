package lejos.nxt;

/** Looks after all regulated motors, every four milliseconds; its monitor guards their moves. */
class MotorRegulation extends Thread {
    /** The milliseconds from one look to the next. */
    static final int PERIOD = 4;

    private MotorMove[] moves = new MotorMove[0];

    MotorRegulation() {
        setPriority(MAX_PRIORITY);
        setDaemon(true);
        start();
        Runtime.getRuntime().addShutdownHook(new Release());
    }

    synchronized void add(MotorMove move) {
        MotorMove[] more = new MotorMove[moves.length + 1];
        System.arraycopy(moves, 0, more, 0, moves.length);
        more[moves.length] = move;
        moves = more;
    }

    public void run() {
        int last = (int) System.currentTimeMillis();
        while (true) {
            try {
                MotorMove[] active;
                boolean hasEnded = false;
                synchronized (this) {
                    if (!isNeeded()) {
                        do {
                            wait();
                        } while (!isNeeded());
                        last = (int) System.currentTimeMillis();
                    }
                    active = moves;
                    int now = (int) System.currentTimeMillis();
                    for (int index = 0; index < active.length; index++) {
                        if (active[index].isActive() && active[index].update(now, now - last)) hasEnded = true;
                    }
                    last = now;
                }
                for (int index = 0; index < active.length; index++) active[index].tellEnd();
                // Only now, so that whoever waits goes on after the listeners.
                if (hasEnded) wake();
                int rest = last + PERIOD - (int) System.currentTimeMillis();
                sleep(rest > 0 ? rest : 1);
            } catch (InterruptedException lookAgain) {
                // Nobody has this thread to interrupt it.
            }
        }
    }

    private synchronized void wake() {
        notifyAll();
    }

    private boolean isNeeded() {
        for (int index = 0; index < moves.length; index++) {
            if (moves[index].isActive()) return true;
        }
        return false;
    }

    /** Lets all motors roll when the program ends. */
    private class Release extends Thread {
        Release() {
        }

        public void run() {
            synchronized (MotorRegulation.this) {
                for (int index = 0; index < moves.length; index++) moves[index].release();
            }
        }
    }
}
