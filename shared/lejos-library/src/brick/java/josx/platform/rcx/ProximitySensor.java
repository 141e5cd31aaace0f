package josx.platform.rcx;

/**
 * Notices that something is near: it sends infrared light, and a light sensor sees more of it the nearer the thing is that throws it back.
 *
 * <p>It sends a pulse every tenth of a second, from its construction to the end of the program. In Robotran's worlds nothing throws infrared
 * light back, so that only other light is noticed.
 */
public class ProximitySensor implements SensorListener {
    private static final int USUAL_THRESHOLD = 15;

    private final Sensor sensor;
    private final int threshold;

    /** Makes one of a light sensor that waits for the light to become brighter by more than 15 percent. */
    public ProximitySensor(Sensor sensor) {
        this(sensor, USUAL_THRESHOLD);
    }

    /** Makes one of a light sensor that waits for the light to become brighter by more than that. */
    public ProximitySensor(Sensor sensor, int threshold) {
        this.sensor = sensor;
        this.threshold = threshold;
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_LIGHT, SensorConstants.SENSOR_MODE_PCT);
        sensor.activate();
        Serial.setRangeLong();
        sensor.addSensorListener(this);
        new Emitter().start();
    }

    /** Waits until something is near, at most so many milliseconds; 0 of them are forever. */
    public void waitTillNear(long milliseconds) throws InterruptedException {
        synchronized (sensor) {
            sensor.wait(milliseconds);
        }
    }

    /** Is called when the light changes; wakes who waits for the light sensor if it has become brighter all at once. */
    public void stateChanged(Sensor source, int oldValue, int newValue) {
        if (newValue - oldValue <= threshold) return;
        synchronized (source) {
            source.notifyAll();
        }
    }

    /** Sends the pulses. */
    private static class Emitter extends Thread {
        private static final int PULSE_MILLISECONDS = 100;

        // No opcode of LEGO's, so that no brick does anything because of it.
        private final byte[] pulse = {(byte) 0xFF};

        Emitter() {
            setDaemon(true);
            setPriority(MAX_PRIORITY);
        }

        public void run() {
            while (true) {
                Serial.sendPacket(pulse, 0, pulse.length);
                try {
                    sleep(PULSE_MILLISECONDS);
                } catch (InterruptedException soonerThanUsual) {
                    // The next pulse comes a little earlier.
                }
            }
        }
    }
}
