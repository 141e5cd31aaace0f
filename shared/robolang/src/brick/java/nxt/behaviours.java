//// REACTIONS

/** Looks all the time whether a behaviour is to take over: of those that want the robot, the last one. */
static class Reactions extends Thread {
    public void run() {
        watchingThread = this;
        Behavior[] behaviours = {@BEHAVIOURS@};
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
}

//// CONTROL, reacting

/** Who has the robot: the main program and a behaviour each look here whether they have to give way. */
static Thread mainThread;
static Thread watchingThread;
static boolean mainIsPaused = true;
static boolean mainStandsStill = false;
static boolean actionIsSuppressed = false;

/** Thrown where a behaviour takes over. */
static final InterruptedException takenOver = new InterruptedException();

//// STOP_AT, reacting

/** Lets the wheels turn until the brick's clock shows this time, then stops them. */
static void stopAt(int time) throws InterruptedException {
    pauseInControl(time);
    pilot.stop();
}

//// PEN_DOWN, reacting

/** Lowers the pen. */
static void penDown() throws InterruptedException {
    PEN.rotateTo(@PEN_DEGREES@, true);
    awaitMotor(PEN);
}

//// PEN_UP, reacting

/** Lifts the pen. */
static void penUp() throws InterruptedException {
    PEN.rotateTo(0, true);
    awaitMotor(PEN);
}

//// TURN_MOTOR, reacting

/** Turns a motor by so many degrees, but only until a behaviour takes over. */
static void turnMotor(NXTRegulatedMotor motor, int angle) throws InterruptedException {
    motor.rotate(angle, true);
    awaitMotor(motor);
}

//// AWAIT_MOTOR, reacting

/** Waits until a motor stands, but only until a behaviour takes over. */
static void awaitMotor(NXTRegulatedMotor motor) throws InterruptedException {
    while (motor.isMoving() && !mustGiveWay()) Thread.sleep(1);
    if (motor.isMoving()) motor.stop(true);
    giveWay();
}
