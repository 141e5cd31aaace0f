package lejos.nxt;

/** A sensor that measures how loud it is. */
public class SoundSensor implements SensorConstants {
    private final ADSensorPort port;

    /** Makes the sensor of a port, which hears all tones alike. */
    public SoundSensor(ADSensorPort port) {
        this(port, false);
    }

    /** Makes the sensor of a port, and says whether it hears like an ear. */
    public SoundSensor(ADSensorPort port, boolean dba) {
        this.port = port;
        port.setMode(MODE_PCTFULLSCALE);
        setDBA(dba);
    }

    /** Says whether it hears like an ear. */
    public void setDBA(boolean dba) {
        port.setType(dba ? TYPE_SOUND_DBA : TYPE_SOUND_DB);
    }

    /** Gives how loud it is, 0 to 100. */
    public int readValue() {
        return port.readValue();
    }
}
