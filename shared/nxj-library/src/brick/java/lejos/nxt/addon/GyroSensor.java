package lejos.nxt.addon;

import lejos.nxt.ADSensorPort;
import lejos.nxt.SensorConstants;
import lejos.robotics.Gyroscope;
import lejos.util.Delay;

/** A gyro of HiTechnic: it measures how fast the robot turns. */
public class GyroSensor implements SensorConstants, Gyroscope {
    private static final int SAMPLES = 100;
    private static final int PERIOD = 5;

    /** The port of the sensor. */
    protected ADSensorPort port;

    private float offset;

    /** Makes the sensor of a port, which measures from 0 to 1023. */
    public GyroSensor(ADSensorPort port) {
        this(port, 0);
    }

    /** Makes the sensor of a port, and says what it measures while the robot does not turn. */
    public GyroSensor(ADSensorPort port, int offset) {
        this.port = port;
        this.offset = offset;
        port.setTypeAndMode(TYPE_CUSTOM, MODE_RAW);
    }

    /** Gives what it measures less the offset. */
    public int readValue() {
        return port.readRawValue() - Math.round(offset);
    }

    /** Sets what it measures while the robot does not turn. */
    public void setOffset(int offset) {
        this.offset = offset;
    }

    /** Gives how fast the robot turns, in degrees a second. */
    public float getAngularVelocity() {
        return port.readRawValue() - offset;
    }

    /** Measures for half a second what it gives while the robot does not turn. */
    public void recalibrateOffset() {
        int sum = 0;
        for (int count = 0; count < SAMPLES; count++) {
            sum += port.readRawValue();
            Delay.msDelay(PERIOD);
        }
        offset = (float) sum / SAMPLES;
    }
}
