// house.robo, translated by Robotran for leJOS on the RCX.

import josx.platform.rcx.*;

// A house with a roof,
// drawn in one go.
public class House {
    /** How many milliseconds the wheels turn for one centimetre. Let the robot draw 100 cm and correct it. */
    static final float MILLISECONDS_PER_CENTIMETRE = 50.0f;

    /** How many milliseconds the wheels turn for one degree. Let the robot turn ten times round and correct it. */
    static final float MILLISECONDS_PER_DEGREE = 5.0f;

    /** How many milliseconds the pen's motor turns to lower or to lift the pen. */
    static final int PEN_MILLISECONDS = 200;

    static final int side = 20; // centimetres

    public static void main(String[] arguments) throws InterruptedException {
        penDown();

        for (int lap = 0; lap < 4; lap++) { // square
            wall(side);
        }

        turnLeftDegrees(60);
        forwardCentimetres(side / 2.5f);
        penUp();

        Motor.A.backward();
        Motor.C.backward();
        Thread.sleep(1500);
        Motor.A.stop();
        Motor.C.stop();
    }

    // One wall, then round the corner.
    static void wall(int length) throws InterruptedException {
        forwardCentimetres(length);
        turnLeftDegrees(90);
    }

    // The methods below do what the commands of Robolang do.

    /** The nearest whole number, a half upwards. */
    static int roundHalfUp(float value) {
        int below = (int) value;
        return value - below >= 0.5f && below < 2147483647 ? below + 1 : below;
    }

    /** Lets the wheels turn for a while, then stops them. */
    static void stopAfter(float milliseconds) throws InterruptedException {
        Thread.sleep(roundHalfUp(milliseconds < 0 ? -milliseconds : milliseconds));
        Motor.A.stop();
        Motor.C.stop();
    }

    /** Drives ahead, or back if there is a minus. */
    static void forwardCentimetres(float distance) throws InterruptedException {
        if (distance < 0) {
            Motor.A.backward();
            Motor.C.backward();
        } else {
            Motor.A.forward();
            Motor.C.forward();
        }
        stopAfter(distance * MILLISECONDS_PER_CENTIMETRE);
    }

    /** Turns on the spot to the left, or to the right if there is a minus. */
    static void turnLeftDegrees(float angle) throws InterruptedException {
        if (angle < 0) {
            Motor.A.forward();
            Motor.C.backward();
        } else {
            Motor.A.backward();
            Motor.C.forward();
        }
        stopAfter(angle * MILLISECONDS_PER_DEGREE);
    }

    /** Lowers the pen. */
    static void penDown() throws InterruptedException {
        Motor.B.forward();
        Thread.sleep(PEN_MILLISECONDS);
        Motor.B.stop();
    }

    /** Lifts the pen. */
    static void penUp() throws InterruptedException {
        Motor.B.backward();
        Thread.sleep(PEN_MILLISECONDS);
        Motor.B.stop();
    }
}
