package lejos.nxt.addon;

import lejos.nxt.LegacySensorPort;
import lejos.nxt.SensorConstants;
import lejos.robotics.Tachometer;
import lejos.util.Delay;

/** The rotation sensor of an RCX, with an adapter cable: it counts sixteen steps a turn. */
public class RCXRotationSensor implements Tachometer, SensorConstants {
    /** How many steps a turn has. */
    public static final int ONE_ROTATION = 16;

    /** How many milliseconds the sensor is left alone between two looks. */
    protected static final int UPDATE_TIME = 2;

    /** The step from one phase to another: 1 forwards, -1 backwards, 0 if there is none. */
    protected static final int[][] inc = {{0, 1, -1, 0}, {-1, 0, 0, 1}, {1, 0, 0, -1}, {0, -1, 1, 0}};

    // The four phases measure about 416, 640, 864 and 992.
    private static final int SECOND_PHASE = 450;
    private static final int THIRD_PHASE = 675;
    private static final int FOURTH_PHASE = 911;
    private static final int DEGREES = 360;
    private static final int MILLISECONDS = 1000;

    /** The port of the sensor. */
    protected LegacySensorPort port;

    /** The steps since they were counted from 0. */
    protected int count;

    /** The thread that counts. */
    protected final Reader reader;

    private int speed;
    private long lastStep = System.currentTimeMillis();

    /** Makes the sensor of a port, and begins to count. */
    public RCXRotationSensor(LegacySensorPort port) {
        this.port = port;
        port.setTypeAndMode(TYPE_ANGLE, MODE_RAW);
        reader = new Reader();
        reader.setDaemon(true);
        reader.setPriority(Thread.MAX_PRIORITY);
        reader.start();
    }

    /** Gives the phase of the sensor: 0, 1, 3 and 2 follow each other forwards. */
    protected int getPhase() {
        int value = port.readRawValue();
        if (value < SECOND_PHASE) return 0;
        if (value < THIRD_PHASE) return 1;
        return value < FOURTH_PHASE ? 2 : 3;
    }

    /** Gives how many degrees the axle has turned since it was counted from 0, in steps of 22.5. */
    public int getTachoCount() {
        return DEGREES * count / ONE_ROTATION;
    }

    /** Gives how many steps the axle has turned since it was counted from 0. */
    public int getRawTachoCount() {
        return count;
    }

    /** Counts from 0. */
    public void resetTachoCount() {
        synchronized (reader) {
            count = 0;
        }
    }

    /** Gives how fast the axle turned at the last step, in degrees a second; it does not become 0 again. */
    public int getRotationSpeed() {
        return speed;
    }

    /** The thread that counts: it believes a phase that it sees twice. */
    protected class Reader extends Thread {
        /** Counts for ever. */
        public void run() {
            int known = getPhase();
            int before = known;
            while (true) {
                int now = getPhase();
                if (now == before && now != known) {
                    synchronized (this) {
                        count += inc[known][now];
                        int elapsed = (int) (System.currentTimeMillis() - lastStep);
                        speed = DEGREES * MILLISECONDS / (elapsed * ONE_ROTATION);
                        lastStep = System.currentTimeMillis();
                    }
                    known = now;
                }
                before = now;
                Delay.msDelay(UPDATE_TIME);
            }
        }
    }
}
