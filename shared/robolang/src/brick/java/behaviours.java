//// SUPPRESS

public void suppress() {
    actionIsSuppressed = true;
}

//// MAIN_PROGRAM

/** The main program has the robot whenever no behaviour wants it. */
static class MainProgram implements Behavior {
    public boolean takeControl() {
        return true;
    }

    public void action() {
        mainIsPaused = false;
    }

    /** Only when the main program has ended what it was at, somebody else may act. */
    public void suppress() {
        mainIsPaused = true;
        while (!mainStandsStill && mainThread.isAlive()) Thread.yield();
    }
}

//// REACTIONS

/** Looks all the time whether a behaviour is to take over. */
static class Reactions extends Thread {
    public void run() {
        watchingThread = this;
        Behavior[] behaviours = {@BEHAVIOURS@};
        new Arbitrator(behaviours).start();
    }
}

//// CONTROL, reacting

/** Who has the robot: the main program and a behaviour each look here whether they have to give way. */
static Thread mainThread;
static Thread watchingThread;
static boolean mainIsPaused = true;
static boolean mainStandsStill = false;
static boolean actionIsSuppressed = false;

/** Thrown again and again, for the brick never takes back the memory of a new one. */
static final InterruptedException takenOver = new InterruptedException();

//// GIVE_WAY, reacting

/** Whether a behaviour wants to take over from who asks. Nobody takes over from who looks at the conditions. */
static boolean mustGiveWay() {
    Thread asking = Thread.currentThread();
    return asking == mainThread ? mainIsPaused : asking != watchingThread && actionIsSuppressed;
}

/** Here the main program stands still while a behaviour has the robot, and an action ends when a later behaviour takes over. */
static void giveWay() throws InterruptedException {
    if (Thread.currentThread() == mainThread) {
        do {
            while (mainIsPaused) {
                mainStandsStill = true;
                Thread.sleep(1);
            }
            mainStandsStill = false;
        } while (mainIsPaused);
    } else if (mustGiveWay()) {
        throw takenOver;
    }
}

//// PAUSE, reacting

/** Lets time pass. */
static void pause(int milliseconds) throws InterruptedException {
    int end = (int) System.currentTimeMillis() + milliseconds;
    if (Thread.currentThread() == mainThread) mainStandsStill = true;
    while (end - (int) System.currentTimeMillis() > 0) {
        Thread.sleep(1);
        if (Thread.currentThread() != mainThread) giveWay();
    }
    giveWay();
}

//// PAUSE_IN_CONTROL, reacting

/** Lets time pass until the brick's clock shows this time, but only until a behaviour takes over. */
static void pauseInControl(int end) throws InterruptedException {
    while (end - (int) System.currentTimeMillis() > 0 && !mustGiveWay()) Thread.sleep(1);
}

//// STOP_AT, reacting

/** Lets the wheels turn until the brick's clock shows this time, then stops them. */
static void stopAt(int time) throws InterruptedException {
    pauseInControl(time);
    Motor.A.stop();
    Motor.C.stop();
    giveWay();
}

//// PEN_DOWN, reacting

/** Lowers the pen. */
static void penDown() throws InterruptedException {
    Motor.B.forward();
    pauseInControl((int) System.currentTimeMillis() + PEN_MILLISECONDS);
    Motor.B.stop();
    giveWay();
}

//// PEN_UP, reacting

/** Lifts the pen. */
static void penUp() throws InterruptedException {
    Motor.B.backward();
    pauseInControl((int) System.currentTimeMillis() + PEN_MILLISECONDS);
    Motor.B.stop();
    giveWay();
}
