//// STOP_AT

/** Lets the wheels turn until the brick's clock shows this time, then stops them. */
static void stopAt(int time) throws InterruptedException {
    int left = time - (int) System.currentTimeMillis();
    if (left > 0) Thread.sleep(left);
    pilot.stop();
}

//// FORWARD_SECONDS

/** Drives ahead for a while. */
static void forwardSeconds(float seconds) throws InterruptedException {
    int end = (int) System.currentTimeMillis() + durationOf(seconds * 1000);
    pilot.forward();
    stopAt(end);
}

//// BACKWARD_SECONDS

/** Drives back for a while. */
static void backwardSeconds(float seconds) throws InterruptedException {
    int end = (int) System.currentTimeMillis() + durationOf(seconds * 1000);
    pilot.backward();
    stopAt(end);
}

//// LEFT_SECONDS

/** Turns on the spot to the left for a while. */
static void turnLeftSeconds(float seconds) throws InterruptedException {
    int end = (int) System.currentTimeMillis() + durationOf(seconds * 1000);
    pilot.rotateLeft();
    stopAt(end);
}

//// RIGHT_SECONDS

/** Turns on the spot to the right for a while. */
static void turnRightSeconds(float seconds) throws InterruptedException {
    int end = (int) System.currentTimeMillis() + durationOf(seconds * 1000);
    pilot.rotateRight();
    stopAt(end);
}

//// PEN_DOWN

/** Lowers the pen. */
static void penDown() {
    PEN.rotateTo(@PEN_DEGREES@);
}

//// PEN_UP

/** Lifts the pen. */
static void penUp() {
    PEN.rotateTo(0);
}

//// SPEED_OF

/** How many degrees a motor of this power, 0 to 7, turns in a second. */
static int speedOf(int power) {
    return power == 0 ? @SLOWEST_SPEED@ : power * @SPEED_OF_POWER@;
}
