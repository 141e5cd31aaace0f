package robotran.robolang.translate

/**
 * The Java helpers of a program with behaviours: those that wait let a behaviour take over. The main program then
 * pauses and resumes later; the action of a behaviour ends; driving and pen movements are cut short.
 */
internal object JavaReactingTexts {
    const val CONTROL = """/** Who has the robot: the main program and a behaviour each look here whether they have to give way. */
static Thread mainThread;
static Thread watchingThread;
static boolean mainIsPaused = true;
static boolean mainStandsStill = false;
static boolean actionIsSuppressed = false;

/** Thrown again and again, for the brick never takes back the memory of a new one. */
static final InterruptedException takenOver = new InterruptedException();"""

    const val GIVE_WAY = """/** Whether a behaviour wants to take over from who asks. Nobody takes over from who looks at the conditions. */
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
}"""

    const val PAUSE = """/** Lets time pass. */
static void pause(int milliseconds) throws InterruptedException {
    int end = (int) System.currentTimeMillis() + milliseconds;
    if (Thread.currentThread() == mainThread) mainStandsStill = true;
    while (end - (int) System.currentTimeMillis() > 0) {
        Thread.sleep(1);
        if (Thread.currentThread() != mainThread) giveWay();
    }
    giveWay();
}"""

    const val PAUSE_IN_CONTROL = """/** Lets time pass until the brick's clock shows this time, but only until a behaviour takes over. */
static void pauseInControl(int end) throws InterruptedException {
    while (end - (int) System.currentTimeMillis() > 0 && !mustGiveWay()) Thread.sleep(1);
}"""

    const val STOP_AT = """/** Lets the wheels turn until the brick's clock shows this time, then stops them. */
static void stopAt(int time) throws InterruptedException {
    pauseInControl(time);
    Motor.A.stop();
    Motor.C.stop();
    giveWay();
}"""

    const val PEN_DOWN = """/** Lowers the pen. */
static void penDown() throws InterruptedException {
    Motor.B.forward();
    pauseInControl((int) System.currentTimeMillis() + PEN_MILLISECONDS);
    Motor.B.stop();
    giveWay();
}"""

    const val PEN_UP = """/** Lifts the pen. */
static void penUp() throws InterruptedException {
    Motor.B.backward();
    pauseInControl((int) System.currentTimeMillis() + PEN_MILLISECONDS);
    Motor.B.stop();
    giveWay();
}"""
}
