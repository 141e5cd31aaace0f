package robotran.robolang.translate

/** The Java in every program with behaviours. */
internal object JavaBehaviourTexts {
    const val SUPPRESS = """public void suppress() {
    actionIsSuppressed = true;
}"""

    const val MAIN_PROGRAM = """/** The main program has the robot whenever no behaviour wants it. */
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
}"""

    /** The list of behaviours replaces `ALL`, lowest priority first. */
    const val REACTIONS = """/** Looks all the time whether a behaviour is to take over. */
static class Reactions extends Thread {
    public void run() {
        watchingThread = this;
        Behavior[] behaviours = {ALL};
        new Arbitrator(behaviours).start();
    }
}"""
}
