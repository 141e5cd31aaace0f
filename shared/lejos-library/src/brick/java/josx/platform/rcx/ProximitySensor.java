package josx.platform.rcx;

/** Notices that something is near: it sends infrared light and looks for its reflection with a light sensor. */
public class ProximitySensor implements SensorListener {
    private static final int DEFAULT_THRESHOLD = 15;

    private final Sensor sensor;
    private final int threshold;

    /** Makes one of a light sensor. */
    public ProximitySensor(Sensor sensor) {
        this(sensor, DEFAULT_THRESHOLD);
    }

    /** Makes one of a light sensor that waits for the light to jump by more than the threshold. */
    public ProximitySensor(Sensor sensor, int threshold) {
        this.sensor = sensor;
        this.threshold = threshold;
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_LIGHT, SensorConstants.SENSOR_MODE_PCT);
        sensor.activate();
        Serial.setRangeLong();
        sensor.addSensorListener(this);
        new Flashes().start();
    }

    /** Waits until something is near, at most so many milliseconds; 0 of them are forever. */
    public void waitTillNear(long milliseconds) throws InterruptedException {
        synchronized (sensor) {
            sensor.wait(milliseconds);
        }
    }

    /** Is called when the light changes; wakes who waits if it jumps. */
    public void stateChanged(Sensor source, int oldValue, int newValue) {
        if (newValue - oldValue <= threshold) return;
        synchronized (sensor) {
            sensor.notifyAll();
        }
    }

    private static class Flashes extends Thread {
        private static final byte[] FLASH = {-1};
        private static final int PAUSE_MILLISECONDS = 100;

        Flashes() {
            setDaemon(true);
            setPriority(MAX_PRIORITY);
        }

        public void run() {
            while (true) {
                Serial.sendPacket(FLASH, 0, 1);
                try {
                    Thread.sleep(PAUSE_MILLISECONDS);
                } catch (InterruptedException goOn) {
                    // Somebody woke it too early, which does no harm.
                }
            }
        }
    }
}
