package lejos.nxt;

/** A port for a sensor of an RCX, which may need power. */
public interface LegacySensorPort extends ADSensorPort {
    /** Gives the sensor power. */
    void activate();

    /** Takes the power from the sensor. */
    void passivate();
}
