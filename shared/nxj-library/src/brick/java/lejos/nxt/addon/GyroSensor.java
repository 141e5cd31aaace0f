package lejos.nxt.addon;

import lejos.nxt.ADSensorPort;
import lejos.nxt.Motor;
import lejos.nxt.SensorConstants;
import lejos.robotics.Gyroscope;
import lejos.util.Delay;

/**
 * A gyro of HiTechnic: it measures how fast the robot turns. While the values hardly change, it takes it that the robot
 * does not turn, and what it then measures on average is 0 degrees a second.
 */
public class GyroSensor implements SensorConstants, Gyroscope {
    private static final int SAMPLES = 1000;
    private static final int FEW_SAMPLES = 100;
    private static final int PERIOD = 5;
    private static final int AGEING_TIME = 5000;
    private static final int STEADY_COUNT = 10;
    private static final float STEADY_DEVIATION = 0.55f;

    /** The port of the sensor. */
    protected ADSensorPort port;

    private int offset;

    // What it has measured while the robot did not turn: the sum, the sum of the squares of deviations, and how often.
    private float sum;
    private float squares;
    private int count = 1;

    private int steady;
    private long begun;
    private boolean isCalibrating;

    /** Makes the sensor of a port, which measures from 0 to 1023. */
    public GyroSensor(ADSensorPort port) {
        this.port = port;
        port.setTypeAndMode(TYPE_CUSTOM, MODE_RAW);
        begun = System.currentTimeMillis();
    }

    /** Makes the sensor of a port, and says what it measures while the robot does not turn. */
    public GyroSensor(ADSensorPort port, int offset) {
        this(port);
        this.offset = offset;
    }

    /** Gives what it measures less the offset. */
    public int readValue() {
        return port.readRawValue() - offset;
    }

    /** Sets what it measures while the robot does not turn. */
    public void setOffset(int offset) {
        this.offset = offset;
    }

    /** Gives how fast the robot turns, in degrees a second; call recalibrateOffset first, and this often. */
    public float getAngularVelocity() {
        int value = readValue();
        float square = (float) Math.pow(value - (sum + value) / (count + 1), 2);
        float deviation = (float) Math.sqrt((squares + square) / (count + 1));
        steady = deviation < STEADY_DEVIATION ? steady + 1 : 0;
        if (steady > STEADY_COUNT || isCalibrating) {
            steady = 0;
            sum += value;
            count++;
            squares += Math.pow(value - sum / count, 2);
        }
        if (System.currentTimeMillis() - begun > AGEING_TIME) {
            begun = System.currentTimeMillis();
            sum /= count;
            squares /= count;
            count = 1;
        }
        return count == 0 ? 0 : value - sum / count;
    }

    /** Measures for five seconds and more what it gives while the robot does not turn, and sets the offset to 0. */
    public void recalibrateOffset() {
        offset = 0;
        squares = 0;
        sum = 0;
        count = 0;
        isCalibrating = true;
        for (int sample = 0; sample < SAMPLES; sample++) {
            getAngularVelocity();
            Delay.msDelay(PERIOD);
        }
        isCalibrating = false;
    }

    /** Waits until the values change by at most 1 for half a second; as in leJOS NXJ, that changes nothing. */
    public void recalibrateOffsetAlt() {
        Motor.A.flt();
        Motor.B.flt();
        Motor.C.flt();
        int lowest;
        int highest;
        do {
            lowest = SAMPLES;
            highest = -SAMPLES;
            for (int sample = 0; sample < FEW_SAMPLES; sample++) {
                int value = readValue();
                highest = Math.max(highest, value);
                lowest = Math.min(lowest, value);
                Delay.msDelay(PERIOD);
            }
        } while (highest - lowest > 1);
    }
}
