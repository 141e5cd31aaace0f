package lejos.nxt;

/** Is told when a sensor measures something else. */
public interface SensorPortListener {
    /** The sensor on the port measures something else: 0 to 1023. */
    void stateChanged(SensorPort port, int oldValue, int newValue);
}
