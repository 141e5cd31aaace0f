// behaviours.robo, translated by Robotran for leJOS on the RCX.

import josx.platform.rcx.*;
import josx.robotics.*;

public class Behaviours {
    /** How many milliseconds the wheels turn for one centimetre. Let the robot draw 100 cm and correct it. */
    static final float MILLISECONDS_PER_CENTIMETRE = 50.0f;

    /** When the timer began, on the brick's clock. */
    static int timerStart = (int) System.currentTimeMillis();

    /** Who has the robot: the main program and a behaviour each look here whether they have to give way. */
    static Thread mainThread;
    static boolean mainIsPaused = false;
    static boolean actionIsSuppressed = false;

    /** Thrown again and again, for the brick never takes back the memory of a new one. */
    static final InterruptedException takenOver = new InterruptedException();

    // Drives on and backs away.
    static int bumps = 0;

    /** Texts are made here, once: where they are shown the brick would make new ones until its memory is full. */
    static final char[] TEXT_OUCH = "OUCH".toCharArray();

    public static void main(String[] arguments) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Sensor.S3.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        mainThread = Thread.currentThread();
        new Reactions().start();

        while (true) {
            giveWay();
            forwardCentimetres(10);
        }
    }

    // The left side first.
    static class Whenever1 implements Behavior {
        private boolean isActive;

        public boolean takeControl() {
            return isActive || Sensor.S1.readBooleanValue();
        }

        public void action() {
            isActive = true;
            actionIsSuppressed = false;
            try {
                bumps = bumps + 1;
                backwardCentimetres(5);
                TextLCD.print(TEXT_OUCH);
            } catch (InterruptedException suppressed) {
                // A later behaviour has taken over.
            }
            isActive = false;
        }

        public void suppress() {
            actionIsSuppressed = true;
        }
    }

    static class Whenever2 implements Behavior {
        private boolean isActive;

        public boolean takeControl() {
            return isActive || timer() > 60 && bumps == 0;
        }

        public void action() {
            isActive = true;
            actionIsSuppressed = false;
            Sound.buzz();
            resetTimer();
            isActive = false;
        }

        public void suppress() {
            actionIsSuppressed = true;
        }
    }

    /** The main program has the robot whenever no behaviour wants it. */
    static class MainProgram implements Behavior {
        public boolean takeControl() {
            return true;
        }

        public void action() {
            mainIsPaused = false;
        }

        public void suppress() {
            mainIsPaused = true;
        }
    }

    /** Looks all the time whether a behaviour is to take over. */
    static class Reactions extends Thread {
        public void run() {
            Behavior[] behaviours = {new MainProgram(), new Whenever1(), new Whenever2()};
            new Arbitrator(behaviours).start();
        }
    }

    // The methods below do what the commands of Robolang do.

    /** Whether a behaviour wants to take over from who asks. */
    static boolean mustGiveWay() {
        return Thread.currentThread() == mainThread ? mainIsPaused : actionIsSuppressed;
    }

    /** Here the main program stands still while a behaviour has the robot, and an action ends when a later behaviour takes over. */
    static void giveWay() throws InterruptedException {
        if (Thread.currentThread() == mainThread) {
            while (mainIsPaused) Thread.sleep(1);
        } else if (actionIsSuppressed) {
            throw takenOver;
        }
    }

    /** Lets time pass. */
    static void pause(int milliseconds) throws InterruptedException {
        int end = (int) System.currentTimeMillis() + milliseconds;
        while (end - (int) System.currentTimeMillis() > 0) {
            Thread.sleep(1);
            if (Thread.currentThread() != mainThread) giveWay();
        }
        giveWay();
    }

    /** Lets time pass, but only until a behaviour takes over. */
    static void pauseInControl(int milliseconds) throws InterruptedException {
        int end = (int) System.currentTimeMillis() + milliseconds;
        while (end - (int) System.currentTimeMillis() > 0 && !mustGiveWay()) Thread.sleep(1);
    }

    /** The nearest whole number, a half upwards. */
    static int roundHalfUp(float value) {
        int below = (int) value;
        return value - below >= 0.5f && below < 2147483647 ? below + 1 : below;
    }

    /** Lets the wheels turn for a while, then stops them. */
    static void stopAfter(float milliseconds) throws InterruptedException {
        pauseInControl(roundHalfUp(milliseconds < 0 ? -milliseconds : milliseconds));
        Motor.A.stop();
        Motor.C.stop();
        giveWay();
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

    /** Drives back, or ahead if there is a minus. */
    static void backwardCentimetres(float distance) throws InterruptedException {
        if (distance < 0) {
            Motor.A.forward();
            Motor.C.forward();
        } else {
            Motor.A.backward();
            Motor.C.backward();
        }
        stopAfter(distance * MILLISECONDS_PER_CENTIMETRE);
    }

    /** The seconds since the start or the last resetTimer. */
    static float timer() {
        return ((int) System.currentTimeMillis() - timerStart) / 1000f;
    }

    /** Lets the timer begin again. */
    static void resetTimer() {
        timerStart = (int) System.currentTimeMillis();
    }
}
