package josx.platform.rcx;

/**
 * Notices that something is near: it sends infrared light, and a light sensor sees more of it the nearer the thing is that throws it back.
 *
 * <p>In Robotran's worlds nothing throws infrared light back, so that only other light is noticed.
 */
public class ProximitySensor implements SensorListener {
    private static final int USUAL_THRESHOLD = 15;

    /** Longer than it takes to send the flash. */
    private static final int MILLISECONDS_A_FLASH = 60;

    /** What a remote control sends while none of its buttons is pressed: no brick does anything because of it. */
    private static final byte[] FLASH = {Opcode.OPCODE_REMOTE_COMMAND, 0, 0};

    private final Sensor sensor;
    private final int threshold;
    private int dark;
    private boolean isNear;

    /** Makes one of a light sensor that waits for the light to become brighter by 15 percent. */
    public ProximitySensor(Sensor sensor) {
        this(sensor, USUAL_THRESHOLD);
    }

    /** Makes one of a light sensor that waits for the light to become brighter by so much. */
    public ProximitySensor(Sensor sensor, int threshold) {
        this.sensor = sensor;
        this.threshold = threshold;
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_LIGHT, SensorConstants.SENSOR_MODE_PCT);
        sensor.activate();
        sensor.addSensorListener(this);
    }

    /** Waits until something is near, at most so many milliseconds; 0 of them are forever. */
    public synchronized void waitTillNear(long milliseconds) throws InterruptedException {
        int end = (int) System.currentTimeMillis() + (int) milliseconds;
        int rest = MILLISECONDS_A_FLASH;
        isNear = false;
        while (!isNear && rest > 0) {
            dark = sensor.readValue();
            Serial.sendPacket(FLASH, 0, FLASH.length);
            if ((int) milliseconds != 0) rest = end - (int) System.currentTimeMillis();
            if (rest > 0) wait(Math.min(rest, MILLISECONDS_A_FLASH));
        }
    }

    /** Is called when the light changes; wakes who waits if it has become bright. */
    public synchronized void stateChanged(Sensor source, int oldValue, int newValue) {
        if (newValue - dark < threshold) return;
        isNear = true;
        notifyAll();
    }
}
