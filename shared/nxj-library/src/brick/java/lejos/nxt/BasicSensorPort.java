package lejos.nxt;

/** A port for a sensor: what every such port can do. */
public interface BasicSensorPort extends SensorConstants {
    /** Gives how the port measures. */
    int getMode();

    /** Gives which kind of sensor it has. */
    int getType();

    /** Sets how the port measures. */
    void setMode(int mode);

    /** Sets which kind of sensor it has. */
    void setType(int type);

    /** Sets which kind of sensor it has and how it measures. */
    void setTypeAndMode(int type, int mode);
}
