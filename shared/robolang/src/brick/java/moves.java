//// CENTIMETRE

/** How many milliseconds the wheels turn for one centimetre. Let the robot draw 100 cm and correct it. */
static final float MILLISECONDS_PER_CENTIMETRE = @MILLISECONDS_PER_CENTIMETRE@;

//// DEGREE

/** How many milliseconds the wheels turn for one degree. Let the robot turn ten times round and correct it. */
static final float MILLISECONDS_PER_DEGREE = @MILLISECONDS_PER_DEGREE@;

//// PEN_TIME

/** How many milliseconds the pen's motor turns to lower or to lift the pen. */
static final int PEN_MILLISECONDS = @PEN_MILLISECONDS@;

//// DURATION_OF

/** How long the wheels turn: whole milliseconds, without a minus. */
static int durationOf(float milliseconds) {
    return roundHalfUp(milliseconds < 0 ? -milliseconds : milliseconds);
}

//// STOP_AT

/** Lets the wheels turn until the brick's clock shows this time, then stops them. */
static void stopAt(int time) throws InterruptedException {
    int left = time - (int) System.currentTimeMillis();
    if (left > 0) Thread.sleep(left);
    Motor.A.stop();
    Motor.C.stop();
}

//// FORWARD_CENTIMETRES

/** Drives ahead, or back if there is a minus. */
static void forwardCentimetres(float distance) throws InterruptedException {
    int duration = durationOf(distance * MILLISECONDS_PER_CENTIMETRE);
    int start = (int) System.currentTimeMillis();
    if (distance < 0) {
        Motor.A.backward();
        Motor.C.backward();
    } else {
        Motor.A.forward();
        Motor.C.forward();
    }
    stopAt(start + duration);
}

//// BACKWARD_CENTIMETRES

/** Drives back, or ahead if there is a minus. */
static void backwardCentimetres(float distance) throws InterruptedException {
    int duration = durationOf(distance * MILLISECONDS_PER_CENTIMETRE);
    int start = (int) System.currentTimeMillis();
    if (distance < 0) {
        Motor.A.forward();
        Motor.C.forward();
    } else {
        Motor.A.backward();
        Motor.C.backward();
    }
    stopAt(start + duration);
}

//// LEFT_DEGREES

/** Turns on the spot to the left, or to the right if there is a minus. */
static void turnLeftDegrees(float angle) throws InterruptedException {
    int duration = durationOf(angle * MILLISECONDS_PER_DEGREE);
    int start = (int) System.currentTimeMillis();
    if (angle < 0) {
        Motor.A.forward();
        Motor.C.backward();
    } else {
        Motor.A.backward();
        Motor.C.forward();
    }
    stopAt(start + duration);
}

//// RIGHT_DEGREES

/** Turns on the spot to the right, or to the left if there is a minus. */
static void turnRightDegrees(float angle) throws InterruptedException {
    int duration = durationOf(angle * MILLISECONDS_PER_DEGREE);
    int start = (int) System.currentTimeMillis();
    if (angle < 0) {
        Motor.A.backward();
        Motor.C.forward();
    } else {
        Motor.A.forward();
        Motor.C.backward();
    }
    stopAt(start + duration);
}

//// FORWARD_SECONDS

/** Drives ahead for a while. */
static void forwardSeconds(float seconds) throws InterruptedException {
    int duration = durationOf(seconds * 1000);
    int start = (int) System.currentTimeMillis();
    Motor.A.forward();
    Motor.C.forward();
    stopAt(start + duration);
}

//// BACKWARD_SECONDS

/** Drives back for a while. */
static void backwardSeconds(float seconds) throws InterruptedException {
    int duration = durationOf(seconds * 1000);
    int start = (int) System.currentTimeMillis();
    Motor.A.backward();
    Motor.C.backward();
    stopAt(start + duration);
}

//// LEFT_SECONDS

/** Turns on the spot to the left for a while. */
static void turnLeftSeconds(float seconds) throws InterruptedException {
    int duration = durationOf(seconds * 1000);
    int start = (int) System.currentTimeMillis();
    Motor.A.backward();
    Motor.C.forward();
    stopAt(start + duration);
}

//// RIGHT_SECONDS

/** Turns on the spot to the right for a while. */
static void turnRightSeconds(float seconds) throws InterruptedException {
    int duration = durationOf(seconds * 1000);
    int start = (int) System.currentTimeMillis();
    Motor.A.forward();
    Motor.C.backward();
    stopAt(start + duration);
}

//// PEN_DOWN

/** Lowers the pen. */
static void penDown() throws InterruptedException {
    Motor.B.forward();
    Thread.sleep(PEN_MILLISECONDS);
    Motor.B.stop();
}

//// PEN_UP

/** Lifts the pen. */
static void penUp() throws InterruptedException {
    Motor.B.backward();
    Thread.sleep(PEN_MILLISECONDS);
    Motor.B.stop();
}

//// WAIT_SECONDS

/** Waits so many seconds. */
static void waitSeconds(float seconds) throws InterruptedException {
    Thread.sleep(roundHalfUp(seconds * 1000));
}

//// WAIT_MILLISECONDS

/** Waits so many milliseconds. */
static void waitMilliseconds(float milliseconds) throws InterruptedException {
    Thread.sleep(roundHalfUp(milliseconds));
}

//// POWER_BOTH

/** Sets how strongly both wheels turn, 0 to 7. */
static void power(int power) {
    Motor.A.setPower(power);
    Motor.C.setPower(power);
}
